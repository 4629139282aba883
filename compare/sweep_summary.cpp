#include "compare/sweep_summary.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "compare/figures.hpp"

namespace lute::compare {

namespace {

std::vector<const SweepPoint*> points_of(const Sweep& sweep, const std::string& program, const std::string& method) {
  std::vector<const SweepPoint*> curve;
  for (const SweepPoint& point : sweep.points) {
    if (point.rendered && point.program == program && point.method == method) curve.push_back(&point);
  }
  return curve;
}

// Without the points that another one beats in both, from the cheapest to the dearest: errors fall along it.
std::vector<const SweepPoint*> front_of(std::vector<const SweepPoint*> curve) {
  std::stable_sort(curve.begin(), curve.end(),
                   [](const SweepPoint* a, const SweepPoint* b) { return a->cpu < b->cpu; });
  std::vector<const SweepPoint*> front;
  for (const SweepPoint* point : curve) {
    if (front.empty() || point->rmse < front.back()->rmse) front.push_back(point);
  }
  return front;
}

}  // namespace

std::optional<double> time_at_error(std::vector<const SweepPoint*> curve, double rmse) {
  const std::vector<const SweepPoint*> front = front_of(std::move(curve));
  if (front.empty() || front.back()->rmse > rmse) return std::nullopt;
  const auto reached = std::find_if(front.begin(), front.end(), [&](const SweepPoint* p) { return p->rmse <= rmse; });
  if (reached == front.begin() || (*reached)->rmse == rmse) return (*reached)->cpu;
  const SweepPoint &before = **(reached - 1), &after = **reached;
  if (!(after.rmse > 0)) return after.cpu;
  const double along = std::log(before.rmse / rmse) / std::log(before.rmse / after.rmse);
  return before.cpu * std::pow(after.cpu / before.cpu, along);
}

std::vector<EqualError> at_equal_error(const Sweep& sweep) {
  const std::vector<const SweepPoint*> own = points_of(sweep, "lute", "method 3");
  std::vector<EqualError> result;
  for (const SweepPoint* point : front_of(points_of(sweep, "POV-Ray", "method 2"))) {
    const std::optional<double> time = time_at_error(own, point->rmse);
    if (time && point->cpu > 0) result.push_back({point->setting, point->rmse, point->cpu, *time});
  }
  return result;
}

namespace {

std::vector<double> shares_of(const Sweep& sweep) {
  std::vector<double> shares;
  for (const EqualError& pair : at_equal_error(sweep)) shares.push_back(pair.share());
  return shares;
}

}  // namespace

std::optional<double> time_share(const Sweep& sweep) {
  const std::vector<double> shares = shares_of(sweep);
  return shares.empty() ? std::nullopt : std::optional(median(shares));
}

std::optional<double> largest_share(const Sweep& sweep) {
  const std::vector<double> shares = shares_of(sweep);
  return shares.empty() ? std::nullopt : std::optional(*std::max_element(shares.begin(), shares.end()));
}

std::string summary(const std::vector<Sweep>& sweeps) {
  int compared = 0, in_every = 0, in_median = 0;
  for (const Sweep& sweep : sweeps) {
    const std::optional<double> share = time_share(sweep);
    if (!share) continue;
    ++compared;
    in_median += *share <= 0.5 ? 1 : 0;
    in_every += *largest_share(sweep) <= 0.5 ? 1 : 0;
  }
  if (compared == 0) return "";
  return "At equal error +AM3 needs at most half of the processor time of POV-Ray's +AM2 in every setting compared on " +
         std::to_string(in_every) + " of " + std::to_string(compared) +
         " scenes, in the middle one of the settings of a scene (their median) on " + std::to_string(in_median) + ".";
}

void write_markdown(std::ostream& out, const std::vector<Sweep>& sweeps, const std::string& circumstances) {
  out << circumstances << "\n\n"
      << summary(sweeps) << "\n\n"
      << "| scene | POV-Ray's switches | error (RMSE) | POV-Ray, s | `+AM3` at that error, s | share | median of the scene |\n"
      << "|---|---|---:|---:|---:|---:|---:|\n";
  for (const Sweep& sweep : sweeps) {
    char text[160];
    std::string median = "–";
    if (const std::optional<double> share = time_share(sweep)) {
      std::snprintf(text, sizeof text, "**%.2f**", *share);
      median = text;
    }
    const std::vector<EqualError> pairs = at_equal_error(sweep);
    if (pairs.empty()) out << "| " << sweep.scene.name << " | none whose error `+AM3` reached | | | | | |\n";
    for (const EqualError& pair : pairs) {
      std::snprintf(text, sizeof text, " | %.4f | %.3f | %.3f | %.2f | ", pair.rmse, pair.reference_cpu, pair.own_cpu, pair.share());
      out << "| " << sweep.scene.name << " | `" << pair.setting << '`' << text << (&pair == &pairs.front() ? median : "") << " |\n";
    }
  }
}

void write_points(std::ostream& out, const std::vector<Sweep>& sweeps, const std::string& circumstances) {
  out << circumstances << "\n\n| scene | settings | program | error (RMSE) | processor s | front |\n|---|---|---|---:|---:|---|\n";
  for (const Sweep& sweep : sweeps) {
    for (const SweepPoint& point : sweep.points) {
      out << "| " << sweep.scene.name << " | `" << point.setting << "` | " << point.program << " | ";
      if (point.rendered) {
        out << formatted("%.4f", point.rmse) << " | " << formatted("%.3f", point.cpu) << " | " << (point.pareto ? "yes" : "") << " |\n";
      } else {
        out << point.failure << " | | |\n";
      }
    }
  }
}

}  // namespace lute::compare
