// What the commands that render scenes with both programs have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "compare/report.hpp"
#include "compare/scene_comparison.hpp"

namespace lute::compare {

struct RunOptions {
  std::string size = "160x120";
  std::string filter;
  int sample = 1;  // every how-manieth scene
  int jobs = 1;
  std::string output = "lute-compare";
  std::string lute = "lute";
  std::string povray = "povray";
  double time_limit = 60;
  double memory_gib = 12;
  std::vector<std::string> switches;
  std::string noise = LUTE_REFERENCE_NOISE;
  bool measure_again = false;
  bool quiet = false;
};

inline constexpr const char* kTableHead =
    "state                within     RMSE     lute:   wall     cpu  POV-Ray: wall  cpu   ratio  scene\n";

void add_run_options(CLI::App& command, RunOptions& options);
ComparisonSettings settings_of(const RunOptions& options);

// Renders, prints the table as it grows (unless quiet), writes report.csv, report.json and report.html to the output
// folder.
std::vector<SceneComparison> run_scenes(const RunOptions& options, const std::vector<std::string>& arguments,
                                        ReportContext& context);

void write_reports(const std::vector<SceneComparison>& comparisons, const ReportContext& context,
                   const std::filesystem::path& folder);

}  // namespace lute::compare
