#include "compare/sweep.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "compare/sweep_summary.hpp"

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

// Halfway on the log–log chart between (1 s, 0.1) and (4 s, 0.025) lies (2 s, 0.05).
TEST(Sweep, TimeAtAnErrorLiesOnTheChartsLine) {
  const SweepPoint cheap = point(1, 0.1), dear = point(4, 0.025), useless = point(3, 0.2);
  const std::vector<const SweepPoint*> curve{&dear, &cheap, &useless};
  EXPECT_DOUBLE_EQ(time_at_error(curve, 0.05).value(), 2);
  EXPECT_DOUBLE_EQ(time_at_error(curve, 0.025).value(), 4);
  EXPECT_DOUBLE_EQ(time_at_error(curve, 0.5).value(), 1);
  EXPECT_FALSE(time_at_error(curve, 0.01));
  EXPECT_FALSE(time_at_error({}, 0.1));
}

TEST(Sweep, SummaryCountsScenesWithHalfTheTime) {
  const auto sweep_with = [](double own_cpu) {
    SweepPoint theirs = point(2, 0.05), ours = point(own_cpu, 0.05);
    theirs.program = "POV-Ray";
    theirs.method = "method 2";
    ours.method = "method 3";
    Sweep sweep;
    sweep.points = {theirs, ours};
    return sweep;
  };
  EXPECT_DOUBLE_EQ(time_share(sweep_with(0.5)).value(), 0.25);
  EXPECT_NE(summary({sweep_with(0.5), sweep_with(1.5)}).find("on 1 of 2 scenes"), std::string::npos);
  EXPECT_EQ(summary({Sweep{}}), "");
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

TEST(Sweep, ReadsItsOwnReport) {
  Sweep sweep;
  sweep.scene.name = "a.pov";
  sweep.points = {point(1, 0.1), point(0, 0, false)};
  const std::vector<Sweep> read = from_json(to_json({sweep}, "A machine."));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(to_json(read, "A machine."), to_json({sweep}, "A machine."));
}

// +AM3 takes 1 s for an error of 0.1, POV-Ray 4 s.
TEST(Sweep, TablesTimesAtEqualError) {
  Sweep sweep;
  sweep.scene.name = "a.pov";
  sweep.points = {point(1, 0.1), point(4, 0.1)};
  sweep.points[0].method = "method 3";
  sweep.points[1].program = "POV-Ray";
  sweep.points[1].method = "method 2";
  sweep.points[1].setting = "+AM2";
  std::ostringstream page;
  write_markdown(page, {sweep}, "A machine.");
  EXPECT_NE(page.str().find("on 1 of 1 scenes"), std::string::npos);
  EXPECT_NE(page.str().find("| a.pov | `+AM2` | 0.1000 | 4.000 | 1.000 | 0.25 | **0.25** |"), std::string::npos);
}

}  // namespace
}  // namespace lute::compare
