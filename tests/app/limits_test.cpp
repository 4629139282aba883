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

// 400 MB of address space, of which the program and its libraries take a part.
TEST_F(Limits, ALimitOnAddressSpaceIsToldWithItsPlace) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer's shadow needs more address space than the limit";
#endif
  const auto run_of = [&](const std::string& text, const std::string& switches) {
    write("large.pov", "#version 3.7;\n" + text);
    const std::string command = "ulimit -v 400000; exec " LUTE_BINARY_DIR "/lute --check " + switches + " " + path("large.pov");
    return run_lute({"-c", command}, "", 0, "/bin/sh");
  };
  for (const char* text : {"#while (1) sphere { 0, 1 } #end\n", "#declare A = array[10000][10000];\n#declare A[0][0] = 1;\n",
                           "#declare S = \"aaaaaaaaaa\";\n#while (1) #declare S = concat(S, S); #end\n",
                           "mesh2 { vertex_vectors { 200000000, #while (1) <1, 2, 3> #end } }\n"}) {
    const LuteRun run = run_of(text, "");
    EXPECT_EQ(run.exit_code, 1) << text;
    EXPECT_THAT(run.error, HasSubstr("large.pov:")) << text;
    EXPECT_THAT(run.error, HasSubstr("more memory than the limit of ")) << text;
  }
  // A limit that was asked for is believed: what is beyond it all the same has a place too.
  const LuteRun run = run_of("#while (1) sphere { 0, 1 } #end\n", "--max-memory 100000");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.error, HasSubstr("large.pov:2:"));
  EXPECT_THAT(run.error, HasSubstr("more memory than there is"));
}

constexpr double kSoon = 5;  // seconds: each takes less than one on a machine that has nothing else to do

// Values made of each other by their names nest as deep as the loop turns; nothing of it stands in the text.
TEST_F(Limits, ValuesThatAreMadeOfEachOtherEndByTheirDepth) {
  const std::string head = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location -3*z }\nlight_source { -9, 1 }\n";
  const auto chain = [&](const std::string& first, const std::string& next, const std::string& use, int turns) {
    return head + "#declare A = " + first + "\n#for (I, 1, " + std::to_string(turns) + ") " + next + " #end\n" + use + "\n";
  };
  struct Case {
    const char *name, *first, *next, *use;
  };
  // 900 are rendered, 50000 refused.
  const Case cases[] = {
      {"union", "sphere { 0, 1 }", "#declare A = union { object { A } sphere { I, 1 } }", "object { A }"},
      {"difference", "sphere { 0, 1 }", "#declare A = difference { object { A } sphere { 9, 1 } }", "object { A }"},
      {"clip", "sphere { 0, 1 }", "#declare A = sphere { 0, 1 clipped_by { A } }", "object { A }"},
      {"bound", "sphere { 0, 1 }", "#declare A = sphere { 0, 1 bounded_by { A } }", "object { A }"},
      {"pigment", "pigment { rgb 1 }", "#declare A = pigment { gradient x pigment_map { [0 A] [1 rgb 1] } }", "sphere { 0, 1 pigment { A } }"},
      {"normal", "normal { bumps 1 }", "#declare A = normal { gradient x normal_map { [0 A] [1 bumps 1] } }", "sphere { 0, 1 normal { A } }"},
      {"texture", "texture { pigment { rgb 1 } }", "#declare A = texture { gradient x texture_map { [0 A] [1 pigment { rgb 1 }] } }",
       "sphere { 0, 1 texture { A } }"},
      {"pattern", "pigment { rgb 1 }", "#declare A = pigment { pigment_pattern { A } }", "sphere { 0, 1 pigment { A } }"},
      {"inside", "pigment { rgb 1 }", "#declare A = pigment { object { sphere { 0, 1 } pigment { rgb 1 } pigment { A } } }", "sphere { 0, 1 pigment { A } }"},
      {"function", "function { x }", "#declare B = A #undef A #declare A = function { B(x, y, z) + 1 } #undef B", "#debug str(A(1, 2, 3), 0, 0)"},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const std::string file = std::string("chain_") + c.name + ".pov";
    std::string text = chain(c.first, c.next, c.use, 900);
    write(file, text);
    const LuteRun small = run_lute({path(file), "+W4", "+H3", "-D", "+O" + path(file + ".png")});
    EXPECT_EQ(small.exit_code, 0) << small.error;
    EXPECT_LT(small.seconds, kSoon);
    text.replace(text.find("900"), 3, "50000");
    write(file, text);
    const LuteRun run = run_lute({"--check", path(file)});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.error, HasSubstr("too deeply: the limit is 1000")) << c.name;
    EXPECT_LT(run.seconds, kSoon);
  }
}

// What doubles at each turn of a loop is refused when it no longer fits, and takes no time before.
TEST_F(Limits, DoublingEndsByItsSwitch) {
  const std::string head = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n";
  const auto run_of = [&](const std::string& name, const std::string& text) {
    write(name + ".pov", head + text);
    return run_lute({"--check", "--max-memory", "100", path(name + ".pov")});
  };
  const auto doubling = [](const std::string& first, const std::string& next) {
    return "#declare A = " + first + " #for (I, 1, 60) #declare A = " + next + " #end\nsphere { 0, 1 }\n";
  };
  for (const auto& [name, text] : {
           std::pair<std::string, std::string>("union", doubling("sphere { 0, 1 }", "union { object { A } object { A translate x } }")),
           {"illuminate", doubling("sphere { 0, 1 }", "union { object { A } object { A double_illuminate } }")},
           {"media", doubling("sphere { 0, 1 hollow interior { media { density { bozo } } } }", "union { object { A } object { A translate x } }")},
           {"clip", doubling("sphere { 0, 1 }", "sphere { 0, 1 clipped_by { A } clipped_by { A } translate x }")},
           {"texture", doubling("texture { pigment { rgb 1 } }", "texture { A } texture { A }")},
           {"string", doubling("\"a\"", "concat(A, A)")}}) {
    SCOPED_TRACE(name);
    const LuteRun run = run_of(name, text);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.error, HasSubstr("more memory than the limit of 100 MB"));
    EXPECT_LT(run.seconds, kSoon);
  }
  const std::string many = "#declare A = sphere { 0, 1 } #for (I, 1, 18) #declare A = union { object { A } object { A translate x } } #end\n";
  EXPECT_EQ(run_of("once", many + "object { A }").exit_code, 0);
  EXPECT_THAT(run_of("often", many + "#for (I, 1, 20) object { A } #end").error, HasSubstr("more memory than the limit of 100 MB"));
}

TEST_F(Limits, FunctionsThatCallEachOtherTwiceEnd) {
  std::string text = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nsphere { 0, 1 }\n#declare f0 = function(x) { x + 1 }\n";
  for (int i = 1; i < 60; ++i) {
    const std::string f = "f" + std::to_string(i - 1);
    text += "#declare f" + std::to_string(i) + " = function(x) { " + f + "(x) + " + f + "(x + 1) }\n";
  }
  write("twice.pov", text + "#debug str(f15(0), 0, 0)\n");
  EXPECT_EQ(run_lute({"--check", path("twice.pov")}).exit_code, 0);
  write("twice.pov", text + "#debug str(f59(0), 0, 0)\n");
  const LuteRun run = run_lute({"--check", path("twice.pov")});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.error, HasSubstr("Functions call each other more than 1000000000 times"));
  EXPECT_THAT(run.error, HasSubstr("twice.pov:64"));
  EXPECT_LT(run.seconds, kSoon);
}

TEST_F(Limits, AFullDiskIsToldWhereItIsMet) {
  ASSERT_TRUE(fs::exists("/dev/full"));
  write("full.pov", "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nsphere { 0, 1 }\n#fopen F \"/dev/full\" write\n#write (F, \"x\")\n");
  const LuteRun run = run_lute({"--check", "--allow-write", "/dev", path("full.pov")});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.error, HasSubstr("full.pov:5"));
  EXPECT_THAT(run.error, HasSubstr("Cannot write to file /dev/full"));
}

}  // namespace
}  // namespace lute
