// One renderer as a program: the reference (POV-Ray) or lute. Both take the same switches.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "compare/process.hpp"

namespace lute::compare {

struct RenderSettings {
  int width = 160;
  int height = 120;
  std::vector<std::string> switches = {"-A", "+WT1"};    // besides size, input and output
  std::string file_type = "N8";                          // of the output: N8 (PNG) or E (OpenEXR, linear, not clamped)
  double time_limit = 60;                                // seconds of wall time
  std::uint64_t memory_limit = std::uint64_t{12} << 30;  // bytes of address space

  // Of each frame of a set (frame_strip.hpp): half as wide and high, since there are many, and ten times the time for all.
  RenderSettings for_frames() const;

  // All switches that decide the picture, as given to both programs.
  std::vector<std::string> picture_switches() const;
  std::string extension() const { return file_type == "E" ? ".exr" : ".png"; }
};

enum class RenderOutcome { kRendered, kRejected, kTimedOut, kCrashed, kNotStarted };

const char* name_of(RenderOutcome outcome);

struct RenderRun {
  RenderOutcome outcome = RenderOutcome::kNotStarted;
  ProcessResult process;
  std::filesystem::path picture;  // exists only if rendered
  std::string messages;           // the end of what it wrote to standard error
};

// Renders `scene` to `picture` in a scratch copy of the scene's folder; the frames of an INI file become a strip.
RenderRun render(const std::string& program, const std::filesystem::path& scene, const std::filesystem::path& picture,
                 const RenderSettings& settings);

// The first line of `program --version` that names a version.
std::string version_of(const std::string& program);

}  // namespace lute::compare
