// The language itself against POV-Ray, byte for byte: what scenes write, what they print, and which error they are refused with.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>

#include "compare/process.hpp"
#include "compare/scratch_folder.hpp"
#include "tests/file_text.hpp"

namespace lute::compare {
namespace {

namespace fs = std::filesystem;

const fs::path kScenes = LUTE_SOURCE_DIR "/tests/conformance/language";

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
  run->written = test::file_text(run->folder.path() / "out.txt");
  run->said = test::file_text(request.standard_error);
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
  const std::string scene = test::file_text(kScenes / (GetParam() + ".pov"));
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
                                         "colors", "geometry", "extents", "files"),
                         [](const auto& test) { return test.param; });

TEST(DebugStream, ShowsWhatTheReferenceShows) {
  const std::string scene = test::file_text(kScenes / "debug.pov");
  const auto lute = run_lute(scene, {"-V", "-GW"});
  const auto reference = run_reference(scene, {"+GDdebug.txt", "-GA"});
  ASSERT_TRUE(reference->result.succeeded()) << reference->said;
  ASSERT_TRUE(lute->result.succeeded()) << lute->said;
  EXPECT_EQ(lute->said, test::file_text(reference->folder.path() / "debug.txt"));
}

// What a scene sees of the command line: chapter 10 §12, check case 15.
TEST(PredeclaredNames, AreTheReferences) {
  const std::string scene =
      "#version 3.7; global_settings { assumed_gamma 1 } #fopen W concat(\"out\", str(frame_number, 0, 0), \".txt\") write\n"
      "#macro F(V) #write(W, str(V, 0, 12), \"\\n\") #end F(clock) F(clock_on) F(clock_delta) F(frame_number) F(initial_frame)\n"
      "F(final_frame) F(initial_clock) F(final_clock) F(image_width) F(image_height) #ifdef (AA) F(AA) #end\n"
      "#write(W, input_file_name) #fclose W camera { } sphere { 0, 1 }\n";
  const std::vector<std::vector<std::string>> cases = {
      {}, {"+K0.1"}, {"Declare=AA=1.23456789"}, {"+KFI1", "+KFF4", "+SF2", "+EF2"}, {"+KFI1", "+KFF4", "+KC", "+SF3", "+EF3"},
      {"+KFI1", "+KFF3", "+KI2", "+KF5", "+SF2", "+EF2"}, {"+KFF1"}, {"+W1234567", "+EC1", "-F"}};
  for (const std::vector<std::string>& switches : cases) {
    const auto lute = run_lute(scene, switches);
    const auto reference = run_reference(scene, switches);
    std::string shown;
    for (const std::string& word : switches) shown += word + " ";
    int files = 0;
    for (int frame = 0; frame <= 4; ++frame) {
      const std::string name = "out" + std::to_string(frame) + ".txt";
      if (fs::exists(reference->folder.path() / name)) ++files;
      EXPECT_EQ(test::file_text(lute->folder.path() / name), test::file_text(reference->folder.path() / name)) << shown << name;
    }
    EXPECT_EQ(files, 1) << shown;
  }
}

}  // namespace
}  // namespace lute::compare
