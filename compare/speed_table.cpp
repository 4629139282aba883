#include "compare/speed_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <stdexcept>

namespace lute::compare {

namespace {

// The fields of a line of CSV; quotes are taken off, commas within them kept.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

SpeedTable sorted(std::vector<SpeedRow> rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const SpeedRow& a, const SpeedRow& b) { return a.ratio() > b.ratio(); });
  return {std::move(rows)};
}

}  // namespace

double SpeedTable::geometric_mean() const {
  if (rows.empty()) return 0;
  double logarithms = 0;
  for (const SpeedRow& row : rows) logarithms += std::log(row.ratio());
  return std::exp(logarithms / static_cast<double>(rows.size()));
}

double SpeedTable::total_ratio() const {
  double lute = 0, reference = 0;
  for (const SpeedRow& row : rows) {
    lute += row.lute;
    reference += row.reference;
  }
  return reference > 0 ? lute / reference : 0;
}

std::size_t SpeedTable::slower() const {
  return static_cast<std::size_t>(std::ranges::count_if(rows, [](const SpeedRow& row) { return row.ratio() > 1; }));
}

SpeedTable speed_table(const std::vector<SceneComparison>& comparisons) {
  std::vector<SpeedRow> rows;
  for (const SceneComparison& c : comparisons) {
    if (c.state == SceneState::kMatch && c.cpu_ratio()) rows.push_back({c.scene.name, c.lute.process.cpu, c.reference.cpu});
  }
  return sorted(std::move(rows));
}

SpeedTable read_speed_table(std::istream& report) {
  constexpr std::array<const char*, 4> kColumns = {"scene", "state", "lute_cpu", "reference_cpu"};
  std::string line;
  std::getline(report, line);
  const std::vector<std::string> head = fields_of(line);
  std::array<std::size_t, 4> at{};
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    const auto column = std::ranges::find(head, kColumns[i]);
    if (column == head.end()) throw std::runtime_error(std::string("a report without the column ") + kColumns[i]);
    at[i] = static_cast<std::size_t>(column - head.begin());
  }
  std::vector<SpeedRow> rows;
  while (std::getline(report, line)) {
    if (line.empty()) continue;
    const std::vector<std::string> fields = fields_of(line);
    if (fields.size() != head.size()) throw std::runtime_error("not a row of a report: " + line);
    if (fields[at[1]] != name_of(SceneState::kMatch)) continue;
    const SpeedRow row{fields[at[0]], std::stod(fields[at[2]]), std::stod(fields[at[3]])};
    if (row.lute > 0 && row.reference > 0) rows.push_back(row);
  }
  return sorted(std::move(rows));
}

void write_markdown(std::ostream& out, const SpeedTable& table, const std::string& circumstances) {
  char text[256];
  out << circumstances << "\n\n";
  std::snprintf(text, sizeof text,
                "%zu matching scenes: geometric mean of the ratios **%.3f**, all times together %.3f, slower than POV-Ray %zu.\n\n",
                table.rows.size(), table.geometric_mean(), table.total_ratio(), table.slower());
  out << text << "| scene | lute, s | POV-Ray, s | ratio |\n|---|---:|---:|---:|\n";
  for (const SpeedRow& row : table.rows) {
    std::snprintf(text, sizeof text, " | %.2f | %.2f | %.3f |\n", row.lute, row.reference, row.ratio());
    out << "| " << row.scene << text;
  }
}

}  // namespace lute::compare
