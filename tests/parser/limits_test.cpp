// Hostile scenes end with a clear error, and reach only the files they may.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "parser/file_permissions.hpp"
#include "parser/machine_memory.hpp"
#include "tests/parser/read_text.hpp"

namespace lute::test {
namespace {

namespace fs = std::filesystem;
using testing::StartsWith;

std::string code_of(const std::string& text, const ParseOptions& options) {
  const Reading reading = read_text(text, options);
  return reading.first_error() == nullptr ? "" : reading.first_error()->code;
}

TEST(Limits, LoopsEnd) {
  ParseOptions options;
  options.limits.loop_turns = 1000;
  EXPECT_EQ(code_of("#while (1) #end", options), "limit-loop-turns");
  EXPECT_EQ(code_of("#for (I, 1, 1e9) #end", options), "limit-loop-turns");
  EXPECT_EQ(code_of("#for (J, 1, 10) #for (I, 1, 99) #end #end", options), "");
  EXPECT_EQ(code_of("#for (J, 1, 10) #for (I, 1, 100) #end #end", options), "limit-loop-turns");
}

TEST(Limits, MacrosThatCallThemselvesTwiceEnd) {
  ParseOptions options;
  options.limits.tokens = 100'000;
  EXPECT_EQ(code_of("#macro R(N) #if (N > 0) R(N - 1) R(N - 1) #end #end R(60)", options), "limit-tokens");
  EXPECT_EQ(code_of("#for (I, 1, 1e9) #end", options), "limit-tokens");
}

TEST(Limits, MemoryIsBounded) {
  ParseOptions options;
  options.limits.memory_bytes = resident_bytes() + (300u << 20);
  EXPECT_EQ(code_of("#declare A = array[10000][10000];", options), "limit-memory");
  EXPECT_EQ(code_of("#declare S = \"aaaaaaaaaa\"; #while (1) #declare S = concat(S, S); #end", options), "limit-memory");
  EXPECT_EQ(code_of("#while (1) sphere { 0, 1 } #end", options), "limit-memory");
  EXPECT_EQ(code_of("#declare A = array[1000]; #for (I, 0, 999) #declare A[I] = I; #end\n"
                    "#while (1) #declare B = array[1000]; #for (I, 0, 999) #declare B[I] = A; #end #declare A = B; #end",
                    options),
            "limit-memory");
  EXPECT_EQ(code_of("mesh2 { vertex_vectors { 2000000000, #while (1) <1, 2, 3> #end } }", options), "limit-memory");
}

TEST(Limits, NestingIsBounded) {
  ParseOptions options;
  options.limits.nesting = 50;
  EXPECT_EQ(code_of("#declare A = " + std::string(60, '(') + "1" + std::string(60, ')') + ";", options), "limit-nesting");
  options.limits.blocks = 5;
  EXPECT_EQ(code_of("union { union { union { union { union { union { } } } } } }", options), "limit-blocks");
}

TEST(Limits, TheDeepestNestingThatCanBeAskedForFitsTheStack) {
  ParseOptions options;
  options.limits.nesting = 2000;
  for (const char* unit : {"(", "-", "<", "sin(", "(1 ? ", "A["}) {
    std::string text = "#declare A = array[2]{0, 0} #declare B = ";
    for (int i = 0; i < 2500; ++i) text += unit;
    EXPECT_NE(code_of(text, options), "") << unit;
  }
  std::string function = "#declare f = function { ";
  for (int i = 0; i < 2500; ++i) function += "(";
  EXPECT_NE(code_of(function, options), "");
  for (const char* unit : {"object { ", "union { ", "sphere { 0, 1 texture { gradient x texture_map { [0 ",
                           "pigment { average pigment_map { [1 "}) {
    std::string text = "union { sphere { 0, 1 } ";
    for (int i = 0; i < 1500; ++i) text += unit;
    EXPECT_NE(code_of(text, options), "") << unit;
  }
}

class Permissions : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::temp_directory_path() / ("lute_permissions_" + std::to_string(::getpid()));
    for (const char* folder : {"scene", "scene/sub", "library", "other"}) fs::create_directories(root_ / folder);
    for (const char* file : {"scene/a.inc", "scene/sub/b.inc", "library/c.inc", "other/d.inc"}) {
      std::ofstream(root_ / file) << "#declare Read = 1;";
    }
  }
  void TearDown() override { fs::remove_all(root_); }
  std::string path(const std::string& name) const { return (root_ / name).string(); }

  std::string error_of(const std::string& text, ParseOptions options = {}) const {
    options.input_file = path("scene/scene.pov");
    options.input_text = "#version 3.7;\n" + text;
    options.library_paths = {path("library")};
    const ParseResult result = parse_scene(options);
    for (const Diagnostic& d : result.diagnostics) {
      if (d.severity == Severity::kError) return d.code;
    }
    return "";
  }
  std::string include(const std::string& name) const { return "#include \"" + path(name) + "\""; }
  std::string open(const std::string& name, const std::string& mode) const {
    return "#fopen F \"" + path(name) + "\" " + mode;
  }

  fs::path root_;
};

TEST_F(Permissions, ASceneReadsFromItsFolderAndTheLibrary) {
  EXPECT_EQ(error_of(include("scene/a.inc")), "");
  EXPECT_EQ(error_of(include("scene/sub/b.inc")), "");
  EXPECT_EQ(error_of(include("library/c.inc")), "");
  EXPECT_EQ(error_of(include("other/d.inc")), "io-restriction");
  EXPECT_EQ(error_of(include("scene/../other/d.inc")), "io-restriction");
  EXPECT_EQ(error_of(open("other/d.inc", "read")), "io-restriction");
  EXPECT_EQ(error_of("#if (file_exists(\"" + path("other/d.inc") + "\")) #end"), "io-restriction");
  EXPECT_EQ(error_of("sphere { 0, 1 pigment { image_map { png \"" + path("other/d.inc") + "\" } } }"), "io-restriction");
}

TEST_F(Permissions, MoreCanBeAllowed) {
  ParseOptions options;
  options.allow_read = {path("other")};
  EXPECT_EQ(error_of(include("other/d.inc"), options), "");
  EXPECT_EQ(error_of(open("other/x.txt", "write"), options), "io-restriction");
  options.allow_write = {path("other")};
  EXPECT_EQ(error_of(open("other/x.txt", "write"), options), "");
  EXPECT_TRUE(fs::exists(path("other/x.txt")));
}

TEST_F(Permissions, ASceneWritesToItsFolderOnly) {
  EXPECT_EQ(error_of(open("scene/x.txt", "write")), "");
  EXPECT_EQ(error_of(open("library/x.txt", "write")), "io-restriction");
  EXPECT_EQ(error_of(open("other/x.txt", "append")), "io-restriction");
  EXPECT_EQ(error_of(open("scene/../other/x.txt", "write")), "io-restriction");
  fs::create_directory_symlink(root_ / "other", root_ / "scene/link");
  EXPECT_EQ(error_of(open("scene/link/x.txt", "write")), "io-restriction");
  EXPECT_FALSE(fs::exists(path("other/x.txt")));
  EXPECT_EQ(error_of(include("scene/link/d.inc")), "") << "a link in the scene's folder may be read through";
}

TEST_F(Permissions, LinksToWhatDoesNotExistYetAreFollowed) {
  fs::create_symlink("../other/w.txt", root_ / "scene/dangling");
  fs::create_symlink(root_ / "scene/dangling", root_ / "scene/two_steps");
  fs::create_symlink("sub/w.txt", root_ / "scene/within");
  fs::create_symlink("circle", root_ / "scene/circle");
  for (const char* mode : {"write", "append"}) {
    for (const char* name : {"scene/dangling", "scene/two_steps", "scene/circle"}) {
      EXPECT_EQ(error_of(open(name, mode)), "io-restriction") << name << ' ' << mode;
    }
    EXPECT_EQ(error_of(open("scene/within", mode)), "");
  }
  EXPECT_FALSE(fs::exists(path("other/w.txt")));
  EXPECT_TRUE(fs::exists(path("scene/sub/w.txt")));
}

TEST_F(Permissions, AFileThatTheSceneHasRewrittenIsReadAnew) {
  const std::string loop = "#for (I, 0, 2) " + open("scene/gen.inc", "write") +
                           " #write(F, concat(\"#declare Gen = \", str(I, 0, 0), \";\")) #fclose F " + include("scene/gen.inc") +
                           " #if (Gen != I) #error \"stale\" #end #end ";
  EXPECT_EQ(error_of(loop), "");
  fs::create_symlink("gen.inc", root_ / "scene/other_name.inc");
  EXPECT_EQ(error_of(include("scene/other_name.inc") + loop + include("scene/other_name.inc") + " #if (Gen != 2) #error \"stale\" #end"),
            "");
  EXPECT_EQ(error_of(include("scene/gen.inc") + open("scene/gen.inc", "append") + " #write(F, \"#declare Gen = 7;\") " +
                     include("scene/gen.inc") + " #if (Gen != 7) #error \"stale\" #end"),
            "")
      << "while it is still open";
}

TEST_F(Permissions, ALargeFileMayOverwriteItself) {
  const std::string end = "#declare Done = 1; " + open("scene/large.inc", "write");
  std::ofstream(root_ / "scene/large.inc") << std::string(12u << 20, ' ') + "#declare Early = 1;\n" + end + "\n" +
                                                  std::string(12u << 20, ' ') + "#declare Late = 1;\n";
  EXPECT_EQ(error_of(include("scene/large.inc") + " #if (Late != 1) #error \"cut\" #end"), "");
  EXPECT_EQ(fs::file_size(root_ / "scene/large.inc"), 0u);
}

TEST(FilePermissions, CompareWholeNamesOfFolders) {
  FilePermissions permissions;
  permissions.allow_read("/srv/scene");
  permissions.allow_read("/srv/with-slash/");
  EXPECT_TRUE(permissions.may_read("/srv/scene/a"));
  EXPECT_FALSE(permissions.may_read("/srv/scenes/a"));
  EXPECT_FALSE(permissions.may_read("/srv/scene/../a"));
  EXPECT_TRUE(permissions.may_read("/srv/with-slash/a"));
  EXPECT_FALSE(permissions.may_write("/srv/scene/a"));
}

}  // namespace
}  // namespace lute::test
