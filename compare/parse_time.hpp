// How long both programs take to read a scene, how much memory, and where they refuse it: lute with --check, POV-Ray with a picture
// of one pixel, which is the least it can be asked for (with photons or radiosity it is more than reading).
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "compare/process.hpp"
#include "compare/scene_files.hpp"

namespace lute::compare {

struct ParseTimeSettings {
  std::string lute_program, reference_program = "povray";
  int runs = 1;             // of each, in turn; the fastest counts
  double time_limit = 300;  // seconds for one run
};

struct ParseTime {
  std::string name;
  ProcessResult lute, reference;
  std::string lute_error, reference_error;  // where: "file:line", the file without its folder; "" if there is none

  bool comparable() const { return lute.succeeded() && reference.succeeded(); }
  bool rejected() const { return !reference_error.empty(); }
  double ratio() const;       // of processor time, lute's over the reference's
  double user_ratio() const;  // of its part that was not spent in the kernel; the kernel knows it to some milliseconds only
};

ParseTime measure_parse_time(const SceneFile& scene, const ParseTimeSettings& settings);

// Where the first error of what a program said is, as in ParseTime. POV-Ray's console breaks its lines anywhere.
std::string lute_error_place(const std::string& said);
std::string reference_error_place(std::string said);

// The geometric mean of what is comparable; 0 if nothing is.
double mean_ratio(const std::vector<ParseTime>& times, double (ParseTime::*ratio)() const = &ParseTime::ratio);

// Markdown. Times, slowest ratio first: seconds of processor time, and with `memory` peak memory.
void write_times(std::ostream& out, std::vector<ParseTime> times, bool memory);
// What the reference rejects, and where both do.
void write_rejections(std::ostream& out, const std::vector<ParseTime>& times);

}  // namespace lute::compare
