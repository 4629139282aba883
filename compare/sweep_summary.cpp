#include "compare/sweep_summary.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lute::compare {

namespace {

std::vector<const SweepPoint*> curve_of(const Sweep& sweep, const std::string& program, const std::string& method) {
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
  const std::vector<const SweepPoint*> own = curve_of(sweep, "lute", "method 3");
  std::vector<EqualError> result;
  for (const SweepPoint* point : front_of(curve_of(sweep, "POV-Ray", "method 2"))) {
    const std::optional<double> time = time_at_error(own, point->rmse);
    if (time && point->cpu > 0) result.push_back({point->setting, point->rmse, point->cpu, *time});
  }
  return result;
}

std::optional<double> time_share(const Sweep& sweep) {
  std::vector<double> shares;
  for (const EqualError& pair : at_equal_error(sweep)) shares.push_back(pair.share());
  if (shares.empty()) return std::nullopt;
  std::sort(shares.begin(), shares.end());
  const std::size_t middle = shares.size() / 2;
  return shares.size() % 2 == 1 ? shares[middle] : 0.5 * (shares[middle - 1] + shares[middle]);
}

std::string summary(const std::vector<Sweep>& sweeps) {
  int compared = 0, half = 0;
  for (const Sweep& sweep : sweeps) {
    const std::optional<double> share = time_share(sweep);
    if (!share) continue;
    ++compared;
    half += *share <= 0.5 ? 1 : 0;
  }
  if (compared == 0) return "";
  return "+AM3 needs at most half of the processor time of POV-Ray's +AM2 at equal error on " + std::to_string(half) +
         " of " + std::to_string(compared) + " scenes.";
}

void write_markdown(std::ostream& out, const std::vector<Sweep>& sweeps, const std::string& machine) {
  out << machine << "\n\n"
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

}  // namespace lute::compare
