#include "compare/sweep.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace lute::compare {
namespace {

SweepPoint point(double cpu, double rmse, bool rendered = true) {
  SweepPoint p;
  p.program = "lute";
  p.setting = "+A0.3";
  p.method = "method 1";
  p.rendered = rendered;
  p.cpu = cpu;
  p.rmse = rmse;
  return p;
}

TEST(Sweep, ParetoFrontHoldsWhatNothingBeatsInBoth) {
  std::vector<SweepPoint> points = {point(1, 0.1), point(2, 0.05), point(3, 0.06), point(0.5, 0.2), point(0, 0, false)};
  mark_pareto_front(points);
  EXPECT_TRUE(points[0].pareto);
  EXPECT_TRUE(points[1].pareto);
  EXPECT_FALSE(points[2].pareto);
  EXPECT_TRUE(points[3].pareto);
  EXPECT_FALSE(points[4].pareto);
}

TEST(Sweep, NamesTheMethodOfTheSwitches) {
  EXPECT_EQ(method_of("-A"), "no antialiasing");
  EXPECT_EQ(method_of("+A0.3"), "method 1");
  EXPECT_EQ(method_of("+AM2 +A0.1 +R3"), "method 2");
  EXPECT_EQ(method_of("+AM3"), "method 3");
  EXPECT_EQ(method_of("+AM3 +AE0.01"), "method 3");
  EXPECT_EQ(method_of("+AM2 -A"), "no antialiasing");
}

TEST(Sweep, PageHasAChartWithEveryPoint) {
  Sweep sweep;
  sweep.scene.name = "a.pov";
  std::ostringstream page;
  sweep.points = {point(1, 0.1), point(2, 0.05)};
  for (SweepPoint& p : sweep.points) p.picture.clear();
  write_html(page, {sweep}, "a machine");
  const std::string text = page.str();
  std::size_t circles = 0;
  for (std::size_t at = text.find("<circle"); at != std::string::npos; at = text.find("<circle", at + 1)) ++circles;
  EXPECT_EQ(circles, 2u);
}

}  // namespace
}  // namespace lute::compare
