#include "compare/parse_time.hpp"

#include <gtest/gtest.h>

#include <sstream>


namespace lute::compare {
namespace {

TEST(ErrorPlace, IsThatOfTheFirstErrorOfEitherProgram) {
  EXPECT_EQ(lute_error_place("a/b.pov: warning: No objects.\na/c.inc:12:3: warning: w\na/b.pov:7:1: error: one\na/b.pov:9:1: error: two\n"),
            "b.pov:7");
  EXPECT_EQ(lute_error_place("a.pov:1:1: warning: error\n"), "");
  // The console breaks lines anywhere, in words too.
  EXPECT_EQ(reference_error_place("File 'x.pov' line 1: Parse Warning: w\nFile '/usr/sha\nre/y.inc' line 1\n07: Parse Err\nor: Expected\nFatal error in\n parser: Cannot"),
            "y.inc:107");
  EXPECT_EQ(reference_error_place("File 'x.pov' line 1: Possible Parse Error: w\nRender Statistics"), "");
  EXPECT_EQ(reference_error_place("File 'x.pov' line 8: Possible Parse Error: Cannot find image file.\nFatal error in parser: Cannot open file."),
            "x.pov:8");
}

ParseTime time_of(const std::string& name, double lute, double reference) {
  ParseTime time;
  time.name = name;
  time.lute.started = time.reference.started = true;
  time.lute.exit_code = time.reference.exit_code = 0;
  time.lute.cpu = lute;
  time.reference.cpu = reference;
  return time;
}

TEST(ParseTimes, AreComparedWhereBothRead) {
  ParseTime rejected = time_of("rejected", 9, 1);
  rejected.reference.exit_code = 1;
  rejected.reference_error = rejected.lute_error = "a.pov:1";
  const std::vector<ParseTime> times = {time_of("fast", 0.1, 1), time_of("slow", 0.4, 1), rejected};
  EXPECT_NEAR(mean_ratio(times), 0.2, 1e-12);  // sqrt(0.1 · 0.4)
  std::ostringstream table, rejections;
  write_times(table, times, false);
  EXPECT_LT(table.str().find("| slow | 0.400 | 1.000 | 0.400 |"), table.str().find("| fast | 0.100 | 1.000 | 0.100 |"));
  EXPECT_EQ(table.str().find("rejected"), std::string::npos);
  write_rejections(rejections, times);
  EXPECT_NE(rejections.str().find("| rejected | a.pov:1 | the same place |"), std::string::npos);
}

}  // namespace
}  // namespace lute::compare
