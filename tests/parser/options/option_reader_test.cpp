#include "parser/options/option_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "parser/options/option_table.hpp"

namespace lute {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Files = std::map<std::string, std::string>;

RenderOptions options_of(const std::vector<std::string>& arguments, const Files& files = {},
                         const Files& variables = {}) {
  const auto look_up = [](const Files& all) {
    return [all](const std::string& name) -> std::optional<std::string> {
      const auto found = all.find(name);
      return found == all.end() ? std::nullopt : std::optional<std::string>(found->second);
    };
  };
  return read_options(arguments, {look_up(variables), look_up(files)});
}

std::string error_of(const std::vector<std::string>& arguments, const Files& files = {}) {
  try {
    options_of(arguments, files);
  } catch (const OptionError& error) {
    return std::string(error.what()) + " | " + error.hint();
  }
  return "no error";
}

TEST(Options, DefaultsAreThoseOfTheReference) {
  const RenderOptions options = options_of({});
  EXPECT_EQ(options.width, 160);
  EXPECT_EQ(options.height, 120);
  EXPECT_EQ(options.quality, 9);
  EXPECT_FALSE(options.antialias);
  EXPECT_EQ(options.antialiasing.method, 0);
}

TEST(Options, TheThreeFormsMeanTheSame) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"+W800", "-h600", "+A0.2", "+R4", "+WT3", "+Lfolder", "+Oout.png", "a.pov"},
        std::vector<std::string>{"width=800", "Height=600", "Antialias=on", "Antialias_Threshold=0.2",
                                 "Antialias_Depth=4", "Work_Threads=3", "Library_Path=folder",
                                 "Output_File_Name=out.png", "Input_File_Name=a.pov"},
        std::vector<std::string>{"--width", "800", "--height=600", "--antialias", "0.2", "--antialias-depth", "4",
                                 "--threads", "3", "--library-path", "folder", "--output", "out.png", "--input",
                                 "a.pov"}}) {
    const RenderOptions options = options_of(arguments);
    EXPECT_EQ(options.width, 800);
    EXPECT_EQ(options.height, 600);
    EXPECT_TRUE(options.antialias);
    EXPECT_EQ(options.antialiasing.method, 1);
    EXPECT_FLOAT_EQ(options.antialiasing.threshold, 0.2f);
    EXPECT_EQ(options.antialiasing.depth, 4);
    EXPECT_EQ(options.threads, 3);
    EXPECT_EQ(options.library_paths.front(), "folder");
    EXPECT_EQ(options.output_file, "out.png");
    EXPECT_EQ(options.input_file, "a.pov");
  }
}

TEST(Options, MinusTurnsOffAndKeepsTheParameter) {
  const RenderOptions options = options_of({"-A0.2"});
  EXPECT_FALSE(options.antialias);
  EXPECT_FLOAT_EQ(options.antialiasing.threshold, 0.2f);
}

TEST(Options, LaterOnesWin) { EXPECT_EQ(options_of({"+W5", "Width=7", "--width", "9"}).width, 9); }

TEST(Options, RangesAreClamped) {
  EXPECT_EQ(options_of({"+Q11"}).quality, 9);
  EXPECT_EQ(options_of({"+A0.3", "+R20"}).antialiasing.depth, 9);
  EXPECT_EQ(options_of({"+A0.3", "+AM7"}).antialiasing.method, 2);
  EXPECT_EQ(options_of({"+A0.3", "+AM4"}).antialiasing.method, 2);
}

TEST(Options, MethodThreeNeedsNoOtherSwitch) {
  EXPECT_EQ(options_of({"+AM3"}).antialiasing.method, 3);
  EXPECT_DOUBLE_EQ(options_of({"+AM3"}).antialiasing.error_bound, 0.01);
  EXPECT_DOUBLE_EQ(options_of({"+AM3", "+AE0.003"}).antialiasing.error_bound, 0.003);
  EXPECT_DOUBLE_EQ(options_of({"--sampling-method", "3", "--antialias-error", "0.02"}).antialiasing.error_bound, 0.02);
  EXPECT_EQ(options_of({"+AM3", "-A"}).antialiasing.method, 0);
  EXPECT_THAT(error_of({"+AM3", "+AE0"}), HasSubstr("above 0 and at most 1"));
}

TEST(Options, SwitchesThatShareTheirFirstLetters) {
  const RenderOptions options =
      options_of({"+KFI3", "+KFF4", "+KI10", "+KF20", "+KC", "+K0.5", "+HR", "+H7", "+HIhead.inc"});
  EXPECT_EQ(options.initial_frame, 3);
  EXPECT_EQ(options.final_frame, 4);
  EXPECT_EQ(options.initial_clock, 10);
  EXPECT_EQ(options.final_clock, 20);
  EXPECT_TRUE(options.cyclic);
  EXPECT_EQ(options.clock, 0.5);
  EXPECT_EQ(options.height, 7);
  EXPECT_EQ(options.include_header, "head.inc");
}

TEST(Options, FileTypes) {
  EXPECT_EQ(options_of({"+FN16"}).output.bits, 16);
  EXPECT_EQ(options_of({"+FC"}).output.format, FileFormat::kTargaRle);
  EXPECT_TRUE(options_of({"+FPg"}).output.greyscale);
  EXPECT_FALSE(options_of({"-F"}).output_to_file);
  EXPECT_EQ(options_of({"--format", "exr"}).output.format, FileFormat::kOpenExr);
  EXPECT_EQ(options_of({"Output_File_Type=N8"}).output.format, FileFormat::kPng);
}

// Chapter 30 §12 M.
TEST(Options, WhatTheReferenceRefuses) {
  for (const char* argument : {"+A1", "+A.3", "+A0", "+Qx", "+FX", "+FJg", "+ZZ", "Foo=5", "+FN16x"}) {
    EXPECT_NE(error_of({argument}), "no error") << argument;
  }
  for (const char* argument : {"+A0.05", "+Q11", "Antialias=maybe"})
    EXPECT_EQ(error_of({argument}), "no error") << argument;
  EXPECT_FALSE(options_of({"+A0.3", "Antialias=maybe"}).antialias);
}

TEST(Options, MistakesNameWhatWasMeant) {
  EXPECT_THAT(error_of({"--witdh", "5"}), HasSubstr("did you mean '--width'?"));
  EXPECT_THAT(error_of({"Antialas=on"}), HasSubstr("did you mean 'Antialias'?"));
  EXPECT_THAT(error_of({"+Wide"}), HasSubstr("a whole number"));
  EXPECT_THAT(error_of({"--width"}), HasSubstr("needs a value"));
}

TEST(Options, EmptyAndHugeImagesAreRefused) {
  EXPECT_THAT(error_of({"+W0"}), HasSubstr("empty"));
  EXPECT_THAT(error_of({"+W2000000", "+H2000000"}), HasSubstr("too large"));
  EXPECT_THAT(error_of({"+W99999999999"}), HasSubstr("too large"));
  EXPECT_THAT(error_of({"+W6", "+SC7"}), HasSubstr("start column"));
}

TEST(Options, BooleansFollowThePrefixRule) {
  for (const char* text : {"on", "true", "yes", "1", "T", "y", "Yes!", "10"}) {
    EXPECT_TRUE(options_of({std::string("Output_Alpha=") + text}).output.alpha) << text;
  }
  for (const char* text : {"off", "no", "0", "maybe"}) {
    EXPECT_FALSE(options_of({"+UA", std::string("Output_Alpha=") + text}).output.alpha) << text;
  }
}

TEST(Options, SystemIniIsTheFirstFound) {
  const Files files{{"/home/a/.povray/3.7/povray.ini", "Width=11"}, {"/etc/povray/3.7/povray.ini", "Width=22"}};
  EXPECT_EQ(options_of({}, files, {{"HOME", "/home/a"}}).width, 11);
  EXPECT_EQ(options_of({}, files).width, 22);
  EXPECT_EQ(options_of({"+W5"}, files).width, 5);
}

TEST(Options, PovincAddsALibraryPath) {
  EXPECT_THAT(options_of({}, {}, {{"POVINC", "/inc"}}).library_paths,
              ElementsAre("/inc", "/usr/share/povray-3.7/include"));
}

TEST(Options, IniSections) {
  const Files files{{"s.ini", "Width=1\n[Small]\nWidth=2\n[LARGE]\nHeight=9\n[small]\nHeight=3\n"}};
  EXPECT_EQ(options_of({"s.ini"}, files).width, 1);
  EXPECT_EQ(options_of({"s[small]"}, files).width, 2);
  EXPECT_EQ(options_of({"s.ini[SMALL]"}, files).height, 3);
}

TEST(Options, IniLines) {
  const Files files{{"a.ini",
                     "; comment\n"
                     "  Input_File_Name = \"my scene.pov\" ; behind\n"
                     "Library_Path='one',two\n"
                     "Width=3 Height=2\n"
                     "+H60 +A0.1 # switches\n"
                     "Declare=size=0.123456789\n"
                     "Declare='name=\"text\"'\n"
                     "Output_File_Name=with some blanks\n"}};
  const RenderOptions options = options_of({"a"}, files);
  EXPECT_EQ(options.input_file, "my scene.pov");
  EXPECT_EQ(options.library_paths[0], "one");
  EXPECT_EQ(options.library_paths[1], "two");
  EXPECT_EQ(options.width, 3);
  EXPECT_EQ(options.height, 60);
  EXPECT_EQ(options.output_file, "with some blanks");
  EXPECT_THAT(options.declares, ElementsAre(std::pair("size", "0.123457"), std::pair("name", "\"text\"")));
}

TEST(Options, NamesMayHaveLettersAbove127) {
  const RenderOptions options = options_of({"a.ini"}, {{"a.ini", "Input_File_Name=\xC3\xA4.pov\n+O\xE4.png  ; gr\xC3\xBCn\n"}});
  EXPECT_EQ(options.input_file, "\xC3\xA4.pov");
  EXPECT_EQ(options.output_file, "\xE4.png");
  EXPECT_THAT(error_of({"a.ini"}, {{"a.ini", "W\xC3\xA4=5\n"}}), HasSubstr("a.ini"));
}

TEST(Options, IniMistakesNameTheLine) {
  EXPECT_THAT(error_of({"a.ini"}, {{"a.ini", "Width=4\n\nWitdh=4\n"}}), HasSubstr("a.ini:3: unknown option 'Witdh'"));
  EXPECT_THAT(error_of({"a.ini"}, {{"a.ini", "Width\"\n"}}), HasSubstr("a.ini:1"));
  EXPECT_THAT(error_of({"a.ini"}, {{"a.ini", "a.ini\n"}}), HasSubstr("endlessly"));
  EXPECT_THAT(error_of({"missing.ini"}), HasSubstr("cannot open"));
}

TEST(Options, OnesWithoutEffectAreTold) {
  EXPECT_TRUE(options_of({"+D", "-P", "Bounding_Method=2"}).notices.empty());
  EXPECT_THAT(options_of({"Pre_Frame_Command=echo a, b"}).notices, ElementsAre(HasSubstr("Pre_Frame_Command")));
}

TEST(Options, EveryLongNameIsUnique) {
  std::map<std::string, int> seen;
  for (const OptionRow& row : option_table()) EXPECT_EQ(++seen[long_name_of(row)], 1) << long_name_of(row);
}

}  // namespace
}  // namespace lute
