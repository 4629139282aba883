// The results of a run, for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "compare/batch.hpp"

namespace lute::compare {

// What was compared: shown at the head of the page.
struct ReportContext {
  std::string title = "lute and POV-Ray";
  std::string reference_version;
  std::string lute_version;
  std::string switches;  // as given to both programs
  std::string machine;   // processor and number of cores
};

// The processor of this machine, for the head of reports.
std::string machine_description();

// Worst first: by state, then by RMSE.
std::vector<const SceneComparison*> worst_first(const std::vector<SceneComparison>& comparisons);

void write_table_row(std::ostream& out, const SceneComparison& comparison);
void write_summary(std::ostream& out, const std::vector<SceneComparison>& comparisons);
void write_csv(std::ostream& out, const std::vector<SceneComparison>& comparisons);
nlohmann::json to_json(const std::vector<SceneComparison>& comparisons, const ReportContext& context);

// One page that needs no other file: pictures are inside it.
void write_html(std::ostream& out, const std::vector<SceneComparison>& comparisons, const ReportContext& context);

}  // namespace lute::compare
