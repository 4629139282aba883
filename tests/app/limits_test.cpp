// What a scene and its INI file may not do, seen from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lute_run.hpp"

namespace lute {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Limits : public LuteFolder {
 protected:
  void SetUp() override {
    LuteFolder::SetUp();
    other_ = fs::path(folder_.string() + "_other");
    fs::create_directories(other_);
  }
  void TearDown() override {
    fs::remove_all(other_);
    LuteFolder::TearDown();
  }
  std::string other(const std::string& name) const { return (other_ / name).string(); }  // outside of the scene's folder

  fs::path other_;
};

TEST_F(Limits, CommandsOfIniFilesAreNeverRun) {
  std::string ini = "Input_File_Name=" + path("small.pov") + "\nWidth=8\nHeight=6\n";
  for (const char* when : {"Pre_Scene", "Pre_Frame", "Post_Frame", "Post_Scene", "User_Abort", "Fatal_Error"}) {
    ini += std::string(when) + "_Command=touch " + path("ran") + "\n";
  }
  write("run.ini", ini);
  const LuteRun run = run_lute({path("run.ini")});
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_THAT(run.error, HasSubstr("Pre_Scene_Command"));
  EXPECT_FALSE(fs::exists(path("ran")));
}

TEST_F(Limits, ScenesAreKeptToTheirFolders) {
  write("write.pov", "#version 3.7;\n#fopen F \"" + other("x.txt") + "\" write\n#write(F, 1)\nsphere { 0, 1 }\n");
  const LuteRun refused = run_lute({"--check", path("write.pov")});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.error, HasSubstr("IO restrictions prohibit write access"));
  EXPECT_THAT(refused.error, HasSubstr("--allow-write"));
  EXPECT_FALSE(fs::exists(other("x.txt")));
  EXPECT_EQ(run_lute({"--check", "--allow-write", other_.string(), path("write.pov")}).exit_code, 0);
  EXPECT_TRUE(fs::exists(other("x.txt")));
}

TEST_F(Limits, ThePicturesFolderBelongsToTheScene) {
  write("write.pov", "#version 3.7;\n#fopen F \"" + other("x.txt") + "\" write\n#write(F, 1)\nsphere { 0, 1 }\n");
  const LuteRun run = run_lute({path("write.pov"), "+W8", "+H6", "+O" + other("p.png")});
  EXPECT_EQ(run.exit_code, 0) << run.error;
}

TEST_F(Limits, EveryErrorIsToldUpToTheNumberAskedFor) {
  std::string scene = "#version 3.7;\n";
  for (int i = 0; i < 30; ++i) scene += "sphere { 0, foo }\n";
  write("errors.pov", scene);
  const auto errors = [&](const std::vector<std::string>& switches) {
    std::vector<std::string> arguments = switches;
    arguments.insert(arguments.end(), {"--check", path("errors.pov")});
    const std::string said = run_lute(arguments).error;
    std::size_t count = 0;
    for (std::size_t at = said.find(": error:"); at != std::string::npos; at = said.find(": error:", at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(errors({}), 20u);
  EXPECT_EQ(errors({"--max-errors", "3"}), 3u);
  EXPECT_EQ(errors({"--max-errors=1"}), 1u);
}

TEST_F(Limits, EndlessScenesEndByTheirSwitch) {
  write("loop.pov", "#version 3.7;\n#while (1) #end\n");
  const LuteRun loop = run_lute({"--check", "--max-loop-turns", "1e5", path("loop.pov")});
  EXPECT_EQ(loop.exit_code, 1);
  EXPECT_THAT(loop.error, HasSubstr("Too many loop turns"));
  write("macro.pov", "#version 3.7;\n#macro R(N) #if (N > 0) R(N - 1) R(N - 1) #end #end\nR(60)\n");
  EXPECT_THAT(run_lute({"--check", "--max-tokens=1e6", path("macro.pov")}).error, HasSubstr("Too many tokens"));
  write("memory.pov", "#version 3.7;\n#while (1) sphere { 0, 1 } #end\n");
  EXPECT_THAT(run_lute({"--check", "--max-memory", "200", path("memory.pov")}).error, HasSubstr("more memory than the limit of 200 MB"));
  write("deep.pov", "#version 3.7;\n#declare A = " + std::string(100, '(') + "1" + std::string(100, ')') + ";\n");
  EXPECT_EQ(run_lute({"--check", path("deep.pov")}).exit_code, 0);
  EXPECT_THAT(run_lute({"--check", "--max-nesting", "50", path("deep.pov")}).error, HasSubstr("nested too deeply"));
}

}  // namespace
}  // namespace lute
