#include "compare/speed_table.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace lute::compare {
namespace {

constexpr const char* kReport =
    "scene,state,within_2_255,rmse,maximum,block98_255,lute_wall,lute_cpu,reference_wall,reference_cpu,cpu_ratio,reason\n"
    "a/fast.pov,match,1,0,0,0,1,0.500,4,2.000,0.25,\n"
    "b/slow.pov,match,1,0,0,0,1,4.000,1,1.000,4.0,\n"
    "c/other.pov,differs,0.5,0.1,1,9,1,9.000,1,1.000,9.0,\"one, two\"\n"
    "d/even.pov,match,1,0,0,0,1,3.000,4,3.000,1.0,\"said, something\"\n";

TEST(SpeedTable, HoldsTheMatchingScenesOfAReportSlowestFirst) {
  std::istringstream report(kReport);
  const SpeedTable table = read_speed_table(report);
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(table.rows[0].scene, "b/slow.pov");
  EXPECT_EQ(table.rows[1].scene, "d/even.pov");
  EXPECT_EQ(table.rows[2].scene, "a/fast.pov");
  EXPECT_DOUBLE_EQ(table.geometric_mean(), 1);  // 1/4 · 4 · 1
  EXPECT_DOUBLE_EQ(table.total_ratio(), 7.5 / 6);
  EXPECT_EQ(table.slower(), 1u);
}

TEST(SpeedTable, RejectsWhatIsNoReport) {
  std::istringstream other("scene,state\na,match\n");
  EXPECT_THROW(read_speed_table(other), std::runtime_error);
  std::istringstream torn(std::string(kReport) + "e/torn.pov,match\n");
  EXPECT_THROW(read_speed_table(torn), std::runtime_error);
}

TEST(SpeedTable, IsATableInMarkdown) {
  std::istringstream report(kReport);
  std::ostringstream section;
  write_markdown(section, read_speed_table(report), "A machine.");
  EXPECT_NE(section.str().find("**1.000**"), std::string::npos);
  EXPECT_NE(section.str().find("| b/slow.pov | 4.00 | 1.00 | 4.000 |"), std::string::npos);
}

}  // namespace
}  // namespace lute::compare
