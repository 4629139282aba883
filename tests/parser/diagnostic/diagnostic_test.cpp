#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/parser/read_text.hpp"

namespace lute::test {
namespace {

std::string shown(std::string_view text) {
  const Reading reading = read_text(text);
  return reading.diagnostics.empty() ? "" : to_text(reading.last());
}

TEST(Diagnostic, MarksTheTokenAndGuessesTheName) {
  EXPECT_EQ(shown("spere { 0, 1 }"),
            "test.pov:2:1: error: Expected 'object or directive', undeclared identifier 'spere' found instead\n"
            "  spere { 0, 1 }\n"
            "  ^~~~~\n"
            "  hint: did you mean 'sphere'?\n");
}

TEST(Diagnostic, ShowsTheWayThroughMacros) {
  EXPECT_EQ(shown("#macro Inner(A)\n  #declare B = sqrt(A);\n#end\n#macro Outer()\n  Inner(-4)\n#end\nOuter()"),
            "test.pov:3:22: error: sqrt of negative number -4.000000\n"
            "    #declare B = sqrt(A);\n"
            "                       ^\n"
            "  in macro 'Inner', called from test.pov:6:3\n"
            "  in macro 'Outer', called from test.pov:8:1\n");
}

TEST(Diagnostic, MarksTheEndOfADeclarationWithoutSemicolon) {
  const Diagnostic d = read_text("#declare A = 5\n#declare B = 6;").last();
  EXPECT_EQ(d.code, "missing-semicolon");
  EXPECT_EQ(d.where.line, 2u);
  EXPECT_EQ(d.where.column, 15u);
}

TEST(Diagnostic, CutsLongLinesAroundThePlace) {
  const std::string text = shown("#declare A = " + std::string(5000, ' ') + "foo;");
  EXPECT_LT(text.size(), 400u);
  EXPECT_NE(text.find("foo"), std::string::npos);
}

TEST(Diagnostic, KeepsOfALongLineNothingFarBehindThePlace) {
  const Diagnostic d = read_text("spere { 0, 1 }" + std::string(1'000'000, ' ')).last();
  EXPECT_LT(d.excerpt.size(), 2000u);
  EXPECT_EQ(d.excerpt.substr(0, 5), "spere");
  EXPECT_NE(to_text(d).find("\n  hint: did you mean 'sphere'?"), std::string::npos);
}

TEST(Diagnostic, IsTheSameInJson) {
  const Reading reading = read_text("#warning \"a \\\"b\\\"\\n\"\nspere { 0, 1 }");
  const nlohmann::json json = nlohmann::json::parse(to_json(reading.diagnostics));
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["severity"], "warning");
  EXPECT_EQ(json[0]["message"], "a \"b\" ");
  EXPECT_EQ(json[1]["line"], 3);
  EXPECT_EQ(json[1]["endColumn"], 6);
  EXPECT_EQ(json[1]["hint"], "did you mean 'sphere'?");
}

TEST(NearestName, IsNearOrNothing) {
  const std::string_view words[] = {"sphere", "sphere_sweep", "torus"};
  EXPECT_EQ(nearest_name("shpere", words), "sphere");
  EXPECT_EQ(nearest_name("banana", words), "");
}

TEST(NearestName, DiffersInCaseAtNoCost) {
  const std::string_view words[] = {"all", "Ball", "fog", "image_width", "r"};
  EXPECT_EQ(nearest_name("ball", words), "Ball");
  EXPECT_EQ(nearest_name("IMAGE_WIDTH", words), "image_width");
  EXPECT_EQ(nearest_name("R", words), "r");
  EXPECT_EQ(nearest_name("s", words), "");
  EXPECT_EQ(nearest_name("Foo", words), "");
}

TEST(NearestName, AShortOneRarelyBeginsOtherwise) {
  const std::string_view words[] = {"red", "gray"};
  EXPECT_EQ(nearest_name("grey", words), "gray");
  EXPECT_EQ(nearest_name("Grey", words), "gray");
}

TEST(NearestName, OfEquallyNearOnesIsTheFirst) {
  const std::string_view words[] = {"bumps", "bmp"}, turned[] = {"bmp", "bumps"};
  EXPECT_EQ(nearest_name("bump", words), "bumps");
  EXPECT_EQ(nearest_name("bump", turned), "bmp");
}

}  // namespace
}  // namespace lute::test
