#include "compare/report.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <thread>

namespace lute::compare {

namespace {

std::string formatted(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

double rmse_or_zero(const SceneComparison& comparison) {
  return comparison.difference ? comparison.difference->rmse : 0;
}

}  // namespace

std::string machine_description() {
  std::ifstream stream("/proc/cpuinfo");
  std::string model = "unknown processor";
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("model name", 0) != 0) continue;
    model = line.substr(line.find(':') + 2);
    break;
  }
  return model + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores";
}

std::vector<const SceneComparison*> worst_first(const std::vector<SceneComparison>& comparisons) {
  std::vector<const SceneComparison*> order;
  for (const SceneComparison& comparison : comparisons) order.push_back(&comparison);
  std::stable_sort(order.begin(), order.end(), [](const SceneComparison* a, const SceneComparison* b) {
    if (is_good(a->state) != is_good(b->state)) return is_good(b->state);
    if (a->state != b->state) return a->state > b->state;
    return rmse_or_zero(*a) > rmse_or_zero(*b);
  });
  return order;
}

void write_table_row(std::ostream& out, const SceneComparison& comparison) {
  char text[400];
  const auto& difference = comparison.difference;
  const auto ratio = comparison.cpu_ratio();
  std::snprintf(
      text, sizeof text, "%-18s %8s %8s  %7s %7s  %7s %7s  %6s  %s", name_of(comparison.state),
      difference ? formatted("%.3f%%", 100 * difference->within).c_str() : "-",
      difference ? formatted("%.5f", difference->rmse).c_str() : "-",
      formatted("%.2f", comparison.lute.process.wall).c_str(), formatted("%.2f", comparison.lute.process.cpu).c_str(),
      formatted("%.2f", comparison.reference.wall).c_str(), formatted("%.2f", comparison.reference.cpu).c_str(),
      ratio ? formatted("%.3f", *ratio).c_str() : "-", comparison.scene.name.c_str());
  out << text;
  if (!comparison.reason.empty()) out << "  [" << comparison.reason << "]";
  out << std::endl;
}

void write_summary(std::ostream& out, const std::vector<SceneComparison>& comparisons) {
  const Summary summary = summarize(comparisons);
  out << comparisons.size() << " scenes:";
  for (const auto& [state, count] : summary.counts) out << ' ' << count << ' ' << name_of(state) << ',';
  if (summary.cpu_ratio > 0) {
    out << " processor time of lute over POV-Ray in matching scenes: " << formatted("%.3f", summary.cpu_ratio)
        << " (geometric mean), worst " << formatted("%.3f", summary.worst_cpu_ratio);
  }
  out << '\n';
}

void write_csv(std::ostream& out, const std::vector<SceneComparison>& comparisons) {
  out << "scene,state,within_2_255,rmse,maximum,block98_255,lute_wall,lute_cpu,reference_wall,reference_cpu,cpu_ratio,"
         "reason\n";
  for (const SceneComparison& c : comparisons) {
    out << csv_field(c.scene.name) << ',' << name_of(c.state) << ',';
    if (c.difference) {
      out << formatted("%.5f", c.difference->within) << ',' << formatted("%.5f", c.difference->rmse) << ','
          << formatted("%.5f", c.difference->maximum) << ',' << formatted("%.2f", c.difference->block98_255) << ',';
    } else {
      out << ",,,,";
    }
    out << formatted("%.3f", c.lute.process.wall) << ',' << formatted("%.3f", c.lute.process.cpu) << ','
        << formatted("%.3f", c.reference.wall) << ',' << formatted("%.3f", c.reference.cpu) << ',';
    if (const auto ratio = c.cpu_ratio()) out << formatted("%.4f", *ratio);
    out << ',' << csv_field(c.reason) << '\n';
  }
}

nlohmann::json to_json(const std::vector<SceneComparison>& comparisons, const ReportContext& context) {
  using nlohmann::json;
  json scenes = json::array();
  for (const SceneComparison& c : comparisons) {
    json scene = {{"scene", c.scene.name}, {"state", name_of(c.state)}, {"reason", c.reason}};
    scene["lute"] = {{"outcome", name_of(c.lute.outcome)},
                     {"wall", c.lute.process.wall},
                     {"cpu", c.lute.process.cpu},
                     {"peak_memory", c.lute.process.peak_memory},
                     {"messages", c.lute.outcome == RenderOutcome::kRendered ? "" : c.lute.messages}};
    scene["reference"] = {
        {"outcome", name_of(c.reference.outcome)}, {"wall", c.reference.wall}, {"cpu", c.reference.cpu}};
    if (c.difference) {
      scene["difference"] = {{"within", c.difference->within},   {"rmse", c.difference->rmse},
                             {"maximum", c.difference->maximum}, {"mean", c.difference->mean},
                             {"psnr", c.difference->psnr},       {"block98_255", c.difference->block98_255}};
    }
    if (const auto ratio = c.cpu_ratio()) scene["cpu_ratio"] = *ratio;
    scenes.push_back(std::move(scene));
  }
  const Summary summary = summarize(comparisons);
  json counts = json::object();
  for (const auto& [state, count] : summary.counts) counts[name_of(state)] = count;
  return {{"reference_version", context.reference_version},
          {"lute_version", context.lute_version},
          {"switches", context.switches},
          {"machine", context.machine},
          {"counts", counts},
          {"cpu_ratio_geometric_mean", summary.cpu_ratio},
          {"cpu_ratio_worst", summary.worst_cpu_ratio},
          {"scenes", scenes}};
}

}  // namespace lute::compare
