// How long both programs take to read a scene, and how much memory: lute with --check, POV-Ray with a picture of one pixel, which
// is the least it can be asked for (with photons or radiosity it is more than reading).
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "compare/process.hpp"
#include "compare/scene_files.hpp"

namespace lute::compare {

struct ParseTimeSettings {
  std::string lute_program = "lute";
  std::string reference_program = "povray";
  int runs = 1;            // of each program; the fastest counts
  double time_limit = 300;  // seconds of one run
};

struct ParseTime {
  std::string name;
  ProcessResult lute, reference;

  bool comparable() const { return lute.succeeded() && reference.succeeded(); }
  double ratio() const;  // of user time, lute's over the reference's
};

ParseTime measure_parse_time(const SceneFile& scene, const ParseTimeSettings& settings);

// The geometric mean of the ratios of what is comparable; 0 if nothing is.
double mean_ratio(const std::vector<ParseTime>& times);

// Rows of a Markdown table: seconds of user time, ratio, peak memory.
void write_table(std::ostream& out, const std::vector<ParseTime>& times);

}  // namespace lute::compare
