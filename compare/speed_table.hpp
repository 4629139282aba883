// How long lute takes beside POV-Ray: the matching scenes of a run, slowest ratio first, and their geometric mean.
#pragma once

#include <istream>
#include <ostream>
#include <string>
#include <vector>

#include "compare/report.hpp"

namespace lute::compare {

struct SpeedRow {
  std::string scene;
  double lute = 0, reference = 0;  // seconds of processor time of the whole process, start-up included

  double ratio() const { return lute / reference; }
};

struct SpeedTable {
  std::vector<SpeedRow> rows;  // the largest ratio first

  double geometric_mean() const;  // of the ratios; 0 if there are no rows
  double total_ratio() const;     // all of lute's time over all of POV-Ray's
  std::size_t slower() const;     // rows in which lute takes longer
};

// The scenes that match; times of other pictures say nothing.
SpeedTable speed_table(const std::vector<SceneComparison>& comparisons);

// The same from the report.csv of a run. Throws std::runtime_error where it is none.
SpeedTable read_speed_table(std::istream& report);

// `circumstances`: machine, switches, versions; one line.
void write_markdown(std::ostream& out, const SpeedTable& table, const std::string& circumstances);

}  // namespace lute::compare
