// Everything that the command line and INI files can ask for, with POV-Ray's defaults. Source: specification chapter 30
// §9.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/output/output_settings.hpp"
#include "engine/render/antialias.hpp"
#include "engine/render/block_grid.hpp"
#include "parser/parse_limits.hpp"

namespace lute {

// What to do with the scene.
enum class Action : std::uint8_t { kRender, kHelp, kVersion, kCheck, kExplain, kDumpTokens, kDumpScene };

struct RenderOptions {
  Action action = Action::kRender;

  // The scene.
  std::string input_file;                  // "-": standard input
  std::string include_header;              // "": none
  std::vector<std::string> library_paths;  // searched in order, after the current directory
  std::vector<std::pair<std::string, std::string>>
      declares;                // names and values as the scene reads them; strings in quotes
  std::optional<int> version;  // times 100; overrides a scene that states none

  // The picture.
  int width = 160, height = 120;
  PartialRender partial;
  Antialiasing antialiasing{.method = 1};  // counts when `antialias` is on
  bool antialias = false;
  int quality = 9;
  int threads = 0;  // 0: as many as there are processors
  int block_size = 32;
  int bounding_threshold = 3;
  bool remove_bounds = true;
  bool split_unions = false;

  // The file.
  OutputSettings output;
  bool output_to_file = true;
  std::string output_file;  // as given; output_path() makes the name
  bool continue_trace = false;

  // Animation (chapter 30 §9.6): absent means "not given", which matters.
  double clock = 0;
  bool clock_given = false;
  std::optional<int> initial_frame, final_frame;
  double initial_clock = 0, final_clock = 1;
  std::optional<double> subset_start, subset_end;
  int frame_step = 1;
  bool cyclic = false;

  // What is said, on standard error.
  bool verbose = true;
  bool statistics = false;
  bool json_diagnostics = false;
  int warning_level = 9;
  bool debug_console = true, warning_console = true, render_console = true, statistic_console = true,
       fatal_console = true;

  ParseLimits limits;  // what a scene may use up while it is read
  std::vector<std::string> allow_read, allow_write;  // folders, beside the scene's, the library paths and the picture's

  std::vector<std::string> notices;  // about options that were accepted without effect
};

// A mistake in the options: nothing is rendered, exit code 2.
class OptionError : public std::runtime_error {
 public:
  explicit OptionError(const std::string& message, std::string hint = {})
      : std::runtime_error(message), hint_(std::move(hint)) {}
  const std::string& hint() const { return hint_; }  // "" or for example "did you mean '--width'?"

 private:
  std::string hint_;
};

}  // namespace lute
