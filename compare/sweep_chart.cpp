#include "compare/sweep_chart.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "compare/curve_name.hpp"
#include "compare/figures.hpp"
#include "compare/html_text.hpp"

namespace lute::compare {

namespace {

constexpr const char* kStyle =
    "text{fill:#5c6878;font:12px system-ui,'DejaVu Sans',sans-serif}.grid{stroke:#8894a3;stroke-opacity:.3}";
constexpr const char* kCurveColours[] = {"#2f6fd0", "#d0602f", "#2f9e62", "#9b4fc0",
                                         "#b8922a", "#3aa3b5", "#c43f6b", "#6b7683"};
constexpr double kWidth = 900, kHeight = 420, kLeft = 70, kRight = 200, kTop = 16, kBottom = 46;
constexpr double kSmallest = 1e-5;  // an error of 0 has no place on a logarithmic axis

// A logarithmic axis over the data and 0.15 decades more at both ends.
struct Axis {
  double low = 0, high = 1;  // log10
  double from = 0, to = 1;   // in the picture

  double place(double value) const {
    return from + (std::log10(std::max(value, kSmallest)) - low) / (high - low) * (to - from);
  }
};

Axis axis_over(const std::vector<double>& values, double from, double to) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  Axis axis{std::log10(std::max(*least, kSmallest)) - 0.15, std::log10(std::max(*most, kSmallest)) + 0.15, from, to};
  return axis;
}

// Lines at 1, 2 and 5 of every decade.
template <typename Draw>
void for_each_tick(const Axis& axis, Draw draw) {
  for (int decade = static_cast<int>(std::floor(axis.low)); decade <= static_cast<int>(std::ceil(axis.high));
       ++decade) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double value = digit * std::pow(10.0, decade);
      if (std::log10(value) >= axis.low && std::log10(value) <= axis.high) draw(value);
    }
  }
}

void write_grid(std::ostream& out, const Axis& x, const Axis& y) {
  for_each_tick(x, [&](double value) {
    const std::string at = formatted("%.1f", x.place(value));
    out << "<line class='grid' x1='" << at << "' x2='" << at << "' y1='" << kTop << "' y2='" << kHeight - kBottom
        << "'/><text x='" << at << "' y='" << kHeight - kBottom + 16 << "' text-anchor='middle'>" << formatted("%g", value)
        << "</text>";
  });
  for_each_tick(y, [&](double value) {
    const std::string at = formatted("%.1f", y.place(value));
    out << "<line class='grid' y1='" << at << "' y2='" << at << "' x1='" << kLeft << "' x2='" << kWidth - kRight
        << "'/><text x='" << kLeft - 8 << "' y='" << at << "' dy='4' text-anchor='end'>" << formatted("%g", value)
        << "</text>";
  });
  out << "<text x='" << (kLeft + kWidth - kRight) / 2 << "' y='" << kHeight - 8
      << "' text-anchor='middle'>processor time, s</text><text transform='translate(16 "
      << (kTop + kHeight - kBottom) / 2 << ") rotate(-90)' text-anchor='middle'>error (RMSE, 0…1)</text>";
}

std::string path_of(const std::vector<const SweepPoint*>& points, const Axis& x, const Axis& y) {
  std::string path;
  for (const SweepPoint* point : points) {
    path +=
        (path.empty() ? "M" : "L") + formatted("%.1f", x.place(point->cpu)) + " " + formatted("%.1f", y.place(point->rmse));
  }
  return path;
}

void write_curve(std::ostream& out, const std::string& name, const std::vector<const SweepPoint*>& points,
                 std::size_t index, const Axis& x, const Axis& y) {
  const char* colour = kCurveColours[index % std::size(kCurveColours)];
  out << "<path fill='none' stroke-width='2' stroke='" << colour << "' d='" << path_of(points, x, y) << "'/>";
  for (const SweepPoint* point : points) {
    out << "<circle r='4.5' fill='" << colour << "' cx='" << formatted("%.1f", x.place(point->cpu)) << "' cy='"
        << formatted("%.1f", y.place(point->rmse)) << "'><title>" << html_text(point->program + " " + point->setting)
        << "</title></circle>";
  }
  const double row = kTop + 14 + 22 * static_cast<double>(index);
  out << "<rect width='14' height='4' rx='2' fill='" << colour << "' x='" << kWidth - kRight + 20 << "' y='" << row - 6
      << "'/><text x='" << kWidth - kRight + 42 << "' y='" << row << "'>" << html_text(name) << "</text>";
}

}  // namespace

void write_chart(std::ostream& out, const Sweep& sweep) {
  std::vector<double> times, errors;
  std::map<std::string, std::vector<const SweepPoint*>> curves;
  std::vector<const SweepPoint*> front;
  for (const SweepPoint& point : sweep.points) {
    if (!point.rendered) continue;
    times.push_back(point.cpu);
    errors.push_back(point.rmse);
    curves[point.program + ", " + curve_of(point.setting)].push_back(&point);
    if (point.pareto) front.push_back(&point);
  }
  if (times.empty()) return;
  const Axis x = axis_over(times, kLeft, kWidth - kRight), y = axis_over(errors, kHeight - kBottom, kTop);
  const auto by_time = [](const SweepPoint* a, const SweepPoint* b) { return a->cpu < b->cpu; };
  out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << kWidth << ' ' << kHeight
      << "' role='img' aria-label='error over processor time'><style>" << kStyle << "</style>";
  write_grid(out, x, y);
  std::sort(front.begin(), front.end(), by_time);
  out << "<path fill='none' stroke='#9aa5b1' stroke-width='10' stroke-opacity='0.35' stroke-linecap='round' "
         "stroke-linejoin='round' d='"
      << path_of(front, x, y) << "'/>";
  std::size_t index = 0;
  for (auto& [name, points] : curves) {
    std::sort(points.begin(), points.end(), by_time);
    write_curve(out, name, points, index++, x, y);
  }
  out << "<text x='" << kWidth - kRight + 20 << "' y='" << kTop + 14 + 22 * static_cast<double>(index)
      << "'>broad line: Pareto front</text></svg>\n";
}

}  // namespace lute::compare
