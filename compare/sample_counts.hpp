// How many samples antialiasing takes: lute's camera rays a pixel beside the samples a pixel of POV-Ray's statistics,
// for the same scene and switches. The rule: within 2 %, and the pictures match.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "compare/renderer.hpp"
#include "compare/scene_files.hpp"

namespace lute::compare {

inline constexpr double kAllowedSampleDifference = 0.02;

struct SampleCount {
  std::string scene, switches;
  double reference = 0, own = 0;  // mean samples a pixel
  double within = 0;              // share of pixels within 2/255
  bool matches = false;           // the pictures

  double difference() const { return own / reference - 1; }
  bool passes() const;
};

// From what a program says after rendering: POV-Ray's 'Pixels: … Samples: …', or the row 'camera' of lute's --stats.
std::optional<double> samples_in(const std::string& messages);

// Renders the scene with both programs. Throws std::runtime_error where one gives no picture or no statistics.
SampleCount count_samples(const SceneFile& scene, const std::string& switches, const RenderSettings& settings,
                          const std::string& lute_program, const std::string& reference_program);

void write_markdown(std::ostream& out, const std::vector<SampleCount>& counts, const std::string& circumstances);

}  // namespace lute::compare
