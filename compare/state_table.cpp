#include "compare/state_table.hpp"

#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace lute::compare {
namespace fs = std::filesystem;

namespace {

constexpr const char* kColumns = "scene,state,within_2_255,rmse,block98_255";

std::optional<double> optional_number(const std::string& text) {
  if (text.empty()) return {};
  return std::stod(text);
}

std::string figure(const std::optional<double>& value, const char* format) {
  if (!value) return {};
  char text[32];
  std::snprintf(text, sizeof text, format, *value);
  return text;
}

bool better_figures(const StateRow& fresh, const StateRow& kept) {
  if (fresh.state != kept.state || !fresh.rmse) return false;
  return !kept.rmse || *fresh.rmse < *kept.rmse - 5e-6;
}

}  // namespace

StateTable read_states(const fs::path& csv) {
  StateTable table;
  std::ifstream stream(csv);
  if (!stream) throw std::runtime_error("cannot read the table of states " + csv.string());
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    if (line.empty()) continue;
    std::istringstream fields(line);
    std::string scene, state, within, rmse, block;
    if (!std::getline(fields, scene, ',') || !std::getline(fields, state, ',')) {
      throw std::runtime_error("not a row of states in " + csv.string() + ": " + line);
    }
    std::getline(fields, within, ',');
    std::getline(fields, rmse, ',');
    std::getline(fields, block, ',');
    table[scene] = {state_named(state), optional_number(within), optional_number(rmse), optional_number(block)};
  }
  return table;
}

void write_states(const StateTable& table, const fs::path& csv) {
  const fs::path draft = csv.string() + ".new";
  std::ofstream out(draft);
  out << kColumns << '\n';
  for (const auto& [scene, row] : table) {
    out << scene << ',' << name_of(row.state) << ',' << figure(row.within, "%.5f") << ',' << figure(row.rmse, "%.5f")
        << ',' << figure(row.block98_255, "%.2f") << '\n';
  }
  out.close();
  if (!out) throw std::runtime_error("cannot write " + draft.string());
  fs::rename(draft, csv);
}

StateRow row_of(const SceneComparison& comparison) {
  StateRow row;
  row.state = comparison.state;
  if (comparison.difference) {
    row.within = comparison.difference->within;
    row.rmse = comparison.difference->rmse;
    row.block98_255 = comparison.difference->block98_255;
  }
  return row;
}

std::vector<StateChange> worsened(const StateTable& table, const std::vector<SceneComparison>& comparisons) {
  std::vector<StateChange> changes;
  for (const SceneComparison& comparison : comparisons) {
    const auto kept = table.find(comparison.scene.name);
    if (comparison.state == SceneState::kReferenceTimeout) continue;
    if (kept == table.end()) {
      if (comparison.state > SceneState::kBothReject) changes.push_back({comparison.scene.name, {}, comparison.state});
    } else if (comparison.state > kept->second.state) {
      changes.push_back({comparison.scene.name, kept->second.state, comparison.state});
    }
  }
  return changes;
}

std::vector<StateChange> improved(const StateTable& table, const std::vector<SceneComparison>& comparisons) {
  std::vector<StateChange> changes;
  for (const SceneComparison& comparison : comparisons) {
    const auto kept = table.find(comparison.scene.name);
    if (kept == table.end()) {
      if (comparison.state <= SceneState::kBothReject) changes.push_back({comparison.scene.name, {}, comparison.state});
    } else if (comparison.state < kept->second.state) {
      changes.push_back({comparison.scene.name, kept->second.state, comparison.state});
    }
  }
  return changes;
}

std::vector<std::string> missing(const StateTable& table, const std::vector<SceneComparison>& comparisons) {
  std::set<std::string> seen;
  for (const SceneComparison& comparison : comparisons) seen.insert(comparison.scene.name);
  std::vector<std::string> names;
  for (const auto& [scene, row] : table)
    if (!seen.contains(scene)) names.push_back(scene);
  return names;
}

void improve(StateTable& table, const std::vector<SceneComparison>& comparisons) {
  for (const SceneComparison& comparison : comparisons) {
    const StateRow fresh = row_of(comparison);
    const auto [kept, added] = table.try_emplace(comparison.scene.name, fresh);
    if (!added && (fresh.state < kept->second.state || better_figures(fresh, kept->second))) kept->second = fresh;
  }
}

}  // namespace lute::compare
