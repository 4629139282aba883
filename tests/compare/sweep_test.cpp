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

// Two settings of POV-Ray, at errors of 0.05 and 0.02, of 2 s each; +AM3 needs `at_first` and `at_second` seconds for them.
Sweep sweep_with(double at_first, double at_second) {
  SweepPoint theirs = point(2, 0.05), theirs_better = point(2.5, 0.02), ours = point(at_first, 0.05), ours_better = point(at_second, 0.02);
  for (SweepPoint* p : {&theirs, &theirs_better}) {
    p->program = "POV-Ray";
    p->method = "method 2";
  }
  ours.method = ours_better.method = "method 3";
  Sweep sweep;
  sweep.points = {theirs, theirs_better, ours, ours_better};
  return sweep;
}

TEST(Sweep, SummaryNamesItsRule) {
  EXPECT_DOUBLE_EQ(time_share(sweep_with(0.5, 1)).value(), (0.25 + 0.4) / 2);
  EXPECT_DOUBLE_EQ(largest_share(sweep_with(0.5, 1)).value(), 0.4);
  // The first is below a half in both settings, the second in the mean of the two alone, the third in none.
  const std::string text = summary({sweep_with(0.5, 1), sweep_with(0.5, 1.5), sweep_with(1.5, 2)});
  EXPECT_NE(text.find("in every setting compared on 1 of 3 scenes"), std::string::npos) << text;
  EXPECT_NE(text.find("(their median) on 2."), std::string::npos) << text;
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
  sweep.points[1].failure = "timeout";
  const SweepCircumstances circumstances{"A machine", "240x180", 3, "lute 1", "POV-Ray 3.7"};
  const nlohmann::json report = to_json({sweep}, circumstances);
  EXPECT_EQ(to_json(from_json(report), circumstances_of(report)), report);
  EXPECT_EQ(circumstances_of(report).text(), "A machine, 240x180 pixels, one thread, medians of 3 runs. lute 1, POV-Ray 3.7.");
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
  EXPECT_NE(page.str().find("on 1 of 1 scenes, in the middle"), std::string::npos);
  EXPECT_NE(page.str().find("| a.pov | `+AM2` | 0.1000 | 4.000 | 1.000 | 0.25 | **0.25** |"), std::string::npos);
}

TEST(Sweep, TablesPointsWithoutAComparison) {
  Sweep sweep;
  sweep.scene.name = "a.pov";
  sweep.points = {point(1, 0.1), point(0, 0, false)};
  sweep.points[0].pareto = true;
  sweep.points[1].failure = "timeout";
  std::ostringstream page;
  write_points(page, {sweep}, "A machine.");
  EXPECT_NE(page.str().find("| a.pov | `+A0.3` | lute | 0.1000 | 1.000 | yes |"), std::string::npos);
  EXPECT_NE(page.str().find("| a.pov | `+A0.3` | lute | timeout | | |"), std::string::npos);
}

TEST(Sweep, QuotesFieldsOfItsCsv) {
  Sweep sweep;
  sweep.scene.name = "a,b.pov";
  sweep.points = {point(1, 0.1)};
  sweep.points[0].setting = "Declare=A=\"x\"";
  std::ostringstream csv;
  write_csv(csv, {sweep});
  EXPECT_NE(csv.str().find("\"a,b.pov\",lute,\"Declare=A=\"\"x\"\"\",method 1,1,1.0000"), std::string::npos) << csv.str();
}

}  // namespace
}  // namespace lute::compare
