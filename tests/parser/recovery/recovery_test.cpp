// One run tells every mistake of a scene, and nothing that only follows from one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "tests/parser/read_text.hpp"

namespace lute::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Line and found token of each error. The text's first line is 2.
std::vector<std::string> errors_of(const std::string& text, ParseOptions options = {}) {
  std::vector<std::string> errors;
  for (const Diagnostic& d : read_text(text, options).diagnostics) {
    if (d.severity != Severity::kError) continue;
    const std::size_t length = d.end_column > d.where.column ? d.end_column - d.where.column : 0;
    const bool inside = d.where.column - 1 < d.excerpt.size();
    errors.push_back(std::to_string(d.where.line) + " " + (inside ? d.excerpt.substr(d.where.column - 1, length) : "end"));
  }
  return errors;
}

TEST(Recovery, GoesOnBehindTheBlockOfTheBrokenStatement) {
  EXPECT_THAT(errors_of("sphere { 0, 1 foo }\nbox { 0, 1 bar }\nsphere { 0, 1 }\ncone { 0 }"),
              ElementsAre("2 foo", "3 bar", "5 }"));
  EXPECT_THAT(errors_of("union {\n  sphere { 0, foo }\n  box { 0, 1 }\n}\nbox { 0, 1 bar }"), ElementsAre("3 foo", "6 bar"));
  EXPECT_THAT(errors_of("union {\nsphere { 0, foo }\nbox { 0, 1 }\n}\nbox { 0, 1 bar }"), ElementsAre("3 foo", "6 bar"));
}

TEST(Recovery, FindsTheNextStatementWhereABraceIsMissing) {
  EXPECT_THAT(errors_of("light_source { 0, 1\nbox { 0, 1 }\nsphere { 0, foo }"), ElementsAre("3 box", "4 foo"));
  EXPECT_THAT(errors_of("union {\n  sphere { 0, 1\n  box { 0, 1 }\n}\nbox { 0, 1 bar }"), ElementsAre("4 box", "6 bar"));
  EXPECT_THAT(errors_of("#declare T = texture { pigment { rgb 1 }\n#declare A = foo;\nsphere { 0, 1 texture { T } }\nbox { bar }"),
              ElementsAre("3 foo", "5 bar"));
}

TEST(Recovery, DropsWhatIsLeftOverOfAStatement) {
  EXPECT_THAT(errors_of("sphere { 0, 1 } }\nbox { 0, 1 bar }"), ElementsAre("2 }", "3 bar"));
  EXPECT_THAT(errors_of("sphere { 0, 1 foo } pigment { rgb 1 } }\nbox { 0, 1 bar }"), ElementsAre("2 foo", "3 bar"));
}

TEST(Recovery, GoesOnBehindADeclaration) {
  EXPECT_THAT(errors_of("#declare A = foo;\n#declare B = 1\n#declare C = bar;"), ElementsAre("2 foo", "3 end", "4 bar"));
  EXPECT_THAT(errors_of("#declare A = sphere { 0, foo }\n#declare B = (1;\nbox { bar }"), ElementsAre("2 foo", "3 ;", "4 bar"));
}

TEST(Recovery, SaysNothingAboutNamesWhoseDeclarationFailed) {
  EXPECT_THAT(errors_of("#declare A = foo;\nsphere { 0, A }\nsphere { 0, 1 texture { A } }\nA\nbox { bar }"),
              ElementsAre("2 foo", "6 bar"));
  EXPECT_THAT(errors_of("#macro M(5) #end\nM(1)\nM(2)\nsphere { 0, bar }"), ElementsAre("2 5", "5 bar"));
  EXPECT_THAT(errors_of("union { sphere { 0, foo } #declare A = 1; }\nsphere { 0, A }"), ElementsAre("2 foo"));
}

TEST(Recovery, SaysNothingAboutNamesThatAMissingFileMayDeclare) {
  EXPECT_THAT(errors_of("#include \"missing.inc\"\nsphere { 0, Radius }\nTree(1)\ntorus { 1 }"),
              ElementsAre("2 \"missing.inc\"", "5 }"));
}

TEST(Recovery, TellsAPlaceOnceHoweverOftenItIsReached) {
  EXPECT_THAT(errors_of("#macro M(R)\n  sphere { 0, R foo }\n#end\nM(1)\nM(2)\nM(3)"), ElementsAre("3 foo"));
  EXPECT_THAT(errors_of("#for (I, 1, 10)\n  sphere { 0, I foo }\n  box { 0, bar }\n#end\nbox { last }"),
              ElementsAre("3 foo", "4 bar", "6 last"));
}

TEST(Recovery, EndsLoopsThatMayNotEndByThemselves) {
  EXPECT_THAT(errors_of("#declare I = 0;\n#while (I < 10)\n  #declare I = I + foo;\n#end\nbox { bar }"),
              ElementsAre("4 foo", "6 bar"));
  // Without the first error the second loop would end; with it, it is given up.
  EXPECT_THAT(errors_of("#declare S = 0; #declare S = foo;\n#declare I = 0; #while (I < 10) #declare I = I + S; #end"),
              ElementsAre("2 foo"));
}

TEST(Recovery, LeavesMacrosThatTheStatementEntered) {
  EXPECT_THAT(errors_of("#macro V() <1, foo> #end\nsphere { V(), 1 }\nbox { bar }"), ElementsAre("2 foo", "4 bar"));
  EXPECT_THAT(errors_of("#macro M()\n  #local A = foo;\n  sphere { 0, A }\n  box { 0, bar }\n#end\nM()\ncone { last }"),
              ElementsAre("3 foo", "5 bar", "8 last"));
}

TEST(Recovery, KeepsConditionalsInOrder) {
  EXPECT_THAT(errors_of("#if (1)\n  sphere { 0, foo }\n#else\n  sphere { 0, unseen }\n#end\nbox { bar }"),
              ElementsAre("3 foo", "7 bar"));
  EXPECT_THAT(errors_of("#if (foo)\n  sphere { 0, unseen }\n#else\n  sphere { 0, unseen }\n#end\nbox { bar }"),
              ElementsAre("2 foo", "7 bar"));
  EXPECT_THAT(errors_of("union { #if (1) sphere { 0, foo } #else box { #end box { 0, 1 } }\nbox { bar }"),
              ElementsAre("2 foo", "3 bar"));
  EXPECT_THAT(errors_of("#switch (1)\n#case (1)\n  sphere { 0, foo }\n#break\n#case (2)\n  box { unseen }\n#end\nbox { bar }"),
              ElementsAre("4 foo", "9 bar"));
}

TEST(Recovery, TellsEveryMistakeInTheLetters) {
  EXPECT_THAT(errors_of("sphere { 0, 1 } \xc3\xa4\nsphere { 0, 1.2.3 }\nbox { bar }").size(), 3u);
}

TEST(Recovery, StopsAtTheLimit) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "sphere { 0, foo }\n";
  EXPECT_EQ(errors_of(text).size(), 20u);
  ParseOptions options;
  options.limits.errors = 3;
  EXPECT_EQ(errors_of(text, options).size(), 3u);
}

TEST(Recovery, StopsWhereTheSceneAsksForIt) {
  EXPECT_THAT(errors_of("sphere { 0, foo }\n#error \"stop\"\nsphere { 0, bar }"), ElementsAre("2 foo", "3 error"));
}

TEST(Recovery, PrintsAndWritesNothingMore) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("lute_recovery_" + std::to_string(::getpid()) + ".txt")).string();
  const Reading reading = read_text("#debug \"before\\n\"\nsphere { 0, foo }\n#debug \"behind\\n\"\n#fopen F \"" + path +
                                    "\" write #write(F, 1) #fclose F\n#fopen F \"" + path + "\" read");
  EXPECT_EQ(reading.printed, "before\n");
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_EQ(reading.diagnostics.size(), 1u);
  const Reading open = read_text("#fopen F \"" + path + "\" write #write(F, \"before\")\nsphere { 0, foo }\n#write(F, \"behind\")");
  EXPECT_EQ(open.diagnostics.size(), 1u);
  std::ifstream in(path);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "before");
  in.close();
  std::filesystem::remove(path);
}

TEST(Recovery, HasNothingToDoInAScenesThatIsRight) { EXPECT_THAT(errors_of("sphere { 0, 1 }"), IsEmpty()); }

}  // namespace
}  // namespace lute::test
