// The page of a sweep as a browser shows it: headless Chromium draws it, and the curves are there in their colours.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "compare/process.hpp"
#include "compare/scratch_folder.hpp"
#include "compare/sweep.hpp"
#include "compare/sweep_chart.hpp"

namespace lute::compare {
namespace {

// Two curves, each a straight line on the chart: ten times the time, a tenth of the error.
Sweep two_curves() {
  Sweep sweep;
  sweep.scene.name = "two curves";
  for (const char* program : {"lute", "POV-Ray"}) {
    for (const double cpu : {0.1, 1.0, 10.0}) {
      SweepPoint point;
      point.program = program;
      point.setting = "+AM2";
      point.method = "method 2";
      point.rendered = true;
      point.cpu = point.program == "lute" ? cpu : 2 * cpu;
      point.rmse = 0.001 / cpu;
      sweep.points.push_back(point);
    }
  }
  mark_pareto_front(sweep.points);
  return sweep;
}

// How many pixels have this colour, but for antialiasing.
int pixels_like(const Picture& picture, int red, int green, int blue) {
  int count = 0;
  for (std::size_t i = 0; i < picture.values.size(); i += Picture::kChannels) {
    const float* v = &picture.values[i];
    const auto near = [](float value, int code) { return std::abs(value * 255 - static_cast<float>(code)) < 3; };
    count += near(v[0], red) && near(v[1], green) && near(v[2], blue) ? 1 : 0;
  }
  return count;
}

Picture screenshot(const std::string& file, const std::string& content, const ScratchFolder& folder) {
  std::ofstream(folder.path() / file) << content;
  ProcessRequest request;
  request.arguments = {"chromium-headless-shell",
                       "--no-sandbox",
                       "--disable-gpu",
                       "--hide-scrollbars",
                       "--window-size=1000,800",
                       "--screenshot=" + (folder.path() / "shot.png").string(),
                       "file://" + (folder.path() / file).string()};
  request.working_directory = folder.path();
  request.time_limit = 120;
  const ProcessResult result = run_process(request);
  EXPECT_TRUE(result.succeeded()) << "exit code " << result.exit_code << " signal " << result.signal;
  return read_picture(folder.path() / "shot.png");
}

// The first two colours of the charts, #2f6fd0 and #d0602f: a line of width 2, three dots of radius 4.5 and a legend.
void expect_curves(const Picture& picture) {
  EXPECT_GT(pixels_like(picture, 0x2f, 0x6f, 0xd0), 500);
  EXPECT_GT(pixels_like(picture, 0xd0, 0x60, 0x2f), 500);
}

TEST(SweepPage, BrowserDrawsTheCurves) {
  const ScratchFolder folder;
  std::ostringstream page;
  write_html(page, {two_curves()}, "a machine");
  expect_curves(screenshot("page.html", page.str(), folder));
}

TEST(SweepPage, ChartAloneIsASvgFile) {
  const ScratchFolder folder;
  std::ostringstream chart;
  write_chart(chart, two_curves());
  expect_curves(screenshot("chart.svg", chart.str(), folder));
}

}  // namespace
}  // namespace lute::compare
