// What `lute --explain` says about these scenes, word for word: tests/app/explain/NAME.txt
// (renewed as tests/golden.hpp says).
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>

#include "compare/process.hpp"
#include "compare/scratch_folder.hpp"
#include "tests/golden.hpp"

namespace lute {
namespace {

namespace fs = std::filesystem;

struct Explained {
  const char* scene;  // below scenes/
  std::vector<std::string> switches = {};
};

void PrintTo(const Explained& explained, std::ostream* out) { *out << explained.scene; }

std::string name_of(const Explained& explained) {
  std::string name = fs::path(explained.scene).stem().string();
  for (const std::string& word : explained.switches) name += "_" + word.substr(1);
  return name;
}

const Explained kScenes[] = {
    {"lecture/background.pov"},      {"lecture/brick.pov"},           {"lecture/color_map.pov"},
    {"lecture/csg_difference.pov"},  {"lecture/cylinder_light.pov"},  {"lecture/filter_transmit.pov"},
    {"lecture/finish.pov"},          {"lecture/interior_fade.pov"},   {"lecture/mesh2.pov"},
    {"lecture/mirror.pov"},          {"lecture/parallel_light.pov"},  {"lecture/refraction.pov"},
    {"lecture/sky_sphere.pov"},      {"lecture/smooth_triangle.pov"}, {"lecture/spotlight.pov"},
    {"lecture/torus.pov"},           {"lecture/torus.pov", {"+Q3"}},  {"lecture/torus.pov", {"+A"}},
    {"lecture/torus.pov", {"+AM3"}}, {"lecture/torus.pov", {"+UA"}},  {"lecture/torus.pov", {"+FN16"}},
    {"showcase/lute.pov"},
    {"feature/pattern/bumps.pov"},   {"feature/pattern/texture_map.pov"},  {"feature/pattern/uv_mapping.pov"},
    {"feature/pattern/crackle.pov"}, {"feature/finish/irid.pov"},          {"feature/finish/diffuse.pov"},
    {"feature/atmosphere/rainbow.pov"}, {"feature/light/light_group.pov"}, {"feature/light/fade.pov"},
    {"feature/light/projected_through.pov"}, {"feature/interior/dispersion.pov"}, {"feature/interior/caustics.pov"},
    {"feature/csg/clipped_by.pov"},  {"feature/camera/focal_blur.pov"},    {"../tests/app/explain/layers.pov"}};

class Explain : public testing::TestWithParam<Explained> {};

TEST_P(Explain, SaysWhatItSaid) {
  const fs::path scene = fs::path(LUTE_SOURCE_DIR) / "scenes" / GetParam().scene;
  const compare::ScratchFolder folder;
  compare::ProcessRequest request;
  request.arguments = {LUTE_BINARY_DIR "/lute", "--explain", scene.filename().string()};
  request.arguments.insert(request.arguments.end(), GetParam().switches.begin(), GetParam().switches.end());
  request.working_directory = scene.parent_path();
  request.standard_output = folder.path() / "plan";
  ASSERT_TRUE(compare::run_process(request).succeeded());
  const fs::path golden = fs::path(LUTE_SOURCE_DIR) / "tests" / "app" / "explain" / (name_of(GetParam()) + ".txt");
  test::expect_golden(golden, test::file_text(request.standard_output));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Explain, testing::ValuesIn(kScenes), [](const auto& test) {
  std::string name;
  for (const char c : name_of(test.param)) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
});

}  // namespace
}  // namespace lute
