// The first pictures of the symmetries in tests/extreme, at ordinary scale and place, against POV-Ray: a symmetry alone would hold for
// a wrong picture, too.
#include <gtest/gtest.h>

#include <filesystem>

#include "compare/match.hpp"
#include "compare/renderer.hpp"
#include "compare/scratch_folder.hpp"

namespace lute::compare {
namespace {

constexpr int kShapes = 30;  // of scenes/extreme/symmetry.pov

Picture picture_by(const std::string& program, int shape, const ScratchFolder& folder) {
  RenderSettings settings;
  settings.width = 80;
  settings.height = 60;
  settings.switches.push_back("Declare=Shape=" + std::to_string(shape));
  const RenderRun run = render(program, std::filesystem::path(LUTE_SOURCE_DIR) / "scenes/extreme/symmetry.pov",
                               folder.path() / "picture.png", settings);
  EXPECT_EQ(run.outcome, RenderOutcome::kRendered) << program << ": " << run.messages;
  return run.outcome == RenderOutcome::kRendered ? read_picture(run.picture) : Picture(80, 60);
}

class SymmetryScene : public testing::TestWithParam<int> {};

TEST_P(SymmetryScene, MatchesAtOrdinaryScale) {
  const ScratchFolder ours, theirs;
  const Difference d = difference(picture_by(LUTE_BINARY_DIR "/lute", GetParam(), ours), picture_by("povray", GetParam(), theirs));
  EXPECT_TRUE(matches(d, std::nullopt)) << 100 * d.within << " % within 2/255";
}

INSTANTIATE_TEST_SUITE_P(Shape, SymmetryScene, testing::Range(0, kShapes));

}  // namespace
}  // namespace lute::compare
