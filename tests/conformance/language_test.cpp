// The language itself against POV-Ray, byte for byte: what scenes write, what they print, and which error they are refused with.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>

#include "compare/process.hpp"
#include "compare/scratch_folder.hpp"

namespace lute::compare {
namespace {

namespace fs = std::filesystem;

const fs::path kScenes = LUTE_SOURCE_DIR "/tests/conformance/language";

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// A scene in a folder of its own, read by one of the programs.
struct Run {
  ScratchFolder folder;
  ProcessResult result;
  std::string written, said;
};

std::unique_ptr<Run> run(const std::string& program, const std::string& scene, const std::vector<std::string>& switches) {
  auto run = std::make_unique<Run>();
  std::ofstream(run->folder.path() / "scene.pov", std::ios::binary) << scene;
  std::ofstream(run->folder.path() / "text.pov", std::ios::binary) << "// for file_exists\n";
  ProcessRequest request;
  request.arguments = {program, "+Iscene.pov", "+W1", "+H1", "-F", "-D"};
  request.arguments.insert(request.arguments.end(), switches.begin(), switches.end());
  request.working_directory = run->folder.path();
  request.standard_error = run->folder.path() / "said.txt";
  request.time_limit = 60;
  run->result = run_process(request);
  run->written = content(run->folder.path() / "out.txt");
  run->said = content(request.standard_error);
  return run;
}

std::unique_ptr<Run> run_lute(const std::string& scene, const std::vector<std::string>& switches) {
  return run(LUTE_BINARY_DIR "/lute", scene, switches);
}
std::unique_ptr<Run> run_reference(const std::string& scene, const std::vector<std::string>& switches) {
  return run("povray", scene, switches);
}

class LanguageScene : public testing::TestWithParam<std::string> {};

// Line by line, so that a failure shows the line; then the whole.
TEST_P(LanguageScene, WritesWhatTheReferenceWrites) {
  const std::string scene = content(kScenes / (GetParam() + ".pov"));
  ASSERT_FALSE(scene.empty());
  const auto lute = run_lute(scene, {"-V"});
  const auto reference = run_reference(scene, {"-V"});
  ASSERT_TRUE(reference->result.succeeded()) << reference->said;
  ASSERT_TRUE(lute->result.succeeded()) << lute->said;
  ASSERT_FALSE(reference->written.empty());
  const std::vector<std::string> expected = lines_of(reference->written), found = lines_of(lute->written);
  for (std::size_t i = 0; i < std::min(expected.size(), found.size()); ++i) {
    EXPECT_EQ(found[i], expected[i]) << "line " << i + 1;
  }
  EXPECT_EQ(lute->written, reference->written);
}

INSTANTIATE_TEST_SUITE_P(All, LanguageScene,
                         testing::Values("precedence", "numbers", "text", "control", "macros", "arrays_splines", "functions",
                                         "colors", "geometry"),
                         [](const auto& test) { return test.param; });

TEST(DebugStream, ShowsWhatTheReferenceShows) {
  const std::string scene = content(kScenes / "debug.pov");
  const auto lute = run_lute(scene, {"-V", "-GW"});
  const auto reference = run_reference(scene, {"+GDdebug.txt", "-GA"});
  ASSERT_TRUE(reference->result.succeeded()) << reference->said;
  ASSERT_TRUE(lute->result.succeeded()) << lute->said;
  EXPECT_EQ(lute->said, content(reference->folder.path() / "debug.txt"));
}

}  // namespace
}  // namespace lute::compare
