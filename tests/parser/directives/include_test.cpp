// Where #include looks, and in which order (specification chapter 10 §6.1); what lute adds to it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "parser/parse.hpp"

namespace lute {
namespace {

namespace fs = std::filesystem;

class Include : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* folder : {"scene", "one", "two"}) fs::create_directories(root_ / folder);
  }
  void TearDown() override { fs::remove_all(root_); }

  // A file that prints its own name.
  void write(const std::string& name) const { std::ofstream(root_ / name) << "#debug \"" << name << "\\n\""; }

  // What is printed when `name` is included, then the code of each diagnostic but those about the scene as a whole.
  std::string include(const std::string& name) const {
    std::string text;
    ParseOptions options;
    options.input_file = (root_ / "scene/scene.pov").string();
    options.input_text = "#version 3.7; global_settings { assumed_gamma 1 } #include \"" + name + "\" sphere { 0, 1 }";
    options.library_paths = {(root_ / "one").string(), (root_ / "two").string()};
    options.on_debug = [&](std::string_view line) { text += line.substr(0, line.size() - 1); };
    const ParseResult result = parse_scene(options);
    for (const Diagnostic& d : result.diagnostics) text += " " + d.code;
    return text;
  }

  fs::path root_ = fs::temp_directory_path() / ("lute_include_" + std::to_string(::getpid()));
};

TEST_F(Include, SearchesTheLibraryPathsInTheirOrder) {
  write("two/a.inc");
  EXPECT_EQ(include("a.inc"), "two/a.inc");
  write("one/a.inc");
  EXPECT_EQ(include("a.inc"), "one/a.inc");
}

TEST_F(Include, TriesOneFormOfTheNameInAllFoldersBeforeTheNext) {
  write("one/a");
  EXPECT_EQ(include("a"), "one/a");
  write("two/a.INC");
  EXPECT_EQ(include("a"), "two/a.INC");
  write("two/a.inc");
  EXPECT_EQ(include("a"), "two/a.inc");
}

TEST_F(Include, LooksBesideTheSceneLast) {
  write("scene/a.inc");
  EXPECT_EQ(include("a.inc"), "scene/a.inc");
  write("two/a.inc");
  EXPECT_EQ(include("a.inc"), "two/a.inc");
}

TEST_F(Include, LooksOnceMoreWithoutRegardToCaseAndSaysSo) {
  write("two/Part.Inc");
  EXPECT_EQ(include("part.inc"), "two/Part.Inc file-case");
  EXPECT_EQ(include("PART"), "two/Part.Inc file-case");
  fs::create_directories(root_ / "two/Sub");
  write("two/Sub/b.inc");
  EXPECT_EQ(include("sub/B.inc"), "two/Sub/b.inc file-case");
  // What is spelled right wins wherever it is.
  write("scene/part.inc");
  EXPECT_EQ(include("part.inc"), "scene/part.inc");
}

TEST_F(Include, SaysWhatIsMissing) { EXPECT_EQ(include("nowhere.inc"), " missing-file missing-include"); }

}  // namespace
}  // namespace lute
