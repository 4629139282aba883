// The parser's entry: scene text in, scene description and diagnostics out.
//
// Errors: whatever is wrong with the scene, a missing file and a used-up limit included, is a diagnostic, and `ok` is false; reading
// goes on after an error where that makes sense (parser/recovery). Nothing is thrown but what the callbacks throw, and std::bad_alloc if there
// is no memory even for the message that there is none.
// Units are those of the scene; degrees stay degrees. Source: specification chapter 10.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/function/function.hpp"
#include "engine/scene/geometry_query.hpp"
#include "engine/scene/scene.hpp"
#include "parser/diagnostic/diagnostic.hpp"
#include "parser/parse_limits.hpp"

namespace lute {

// Animation values as the scene sees them (specification chapter 10 §12.3); all zero for a still image.
struct FrameValues {
  int frame_number = 0, initial_frame = 0, final_frame = 0;
  double initial_clock = 0, final_clock = 0, clock_delta = 0;
};

struct ParseOptions {
  std::string input_file;                 // path as given; shown in messages
  std::optional<std::string> input_text;  // used in place of the file's content
  std::vector<std::string> library_paths;
  std::vector<std::pair<std::string, std::string>> declares;  // Declare=NAME=value; a value in quotes is a string
  double clock = 0;
  bool clock_on = false;
  FrameValues frame;
  int width = 320, height = 240;
  std::optional<int> version;             // Version= option, times 100
  std::string include_header;             // "" or a file that is included before the scene
  ParseLimits limits;
  std::vector<std::string> allow_read, allow_write;  // folders beside those of parser/file_permissions.hpp

  GeometryQuery* geometry = nullptr;            // answers trace, inside, min_extent, max_extent
  TextureFunctions* texture_functions = nullptr;  // makes functions of pigments and patterns
  std::function<void(const Diagnostic&)> on_diagnostic;  // as they come
  std::function<void(std::string_view)> on_debug;        // #debug: complete lines
};

struct ParseResult {
  bool ok = false;  // false: there is an error among the diagnostics, and the scene is not complete
  Scene scene;
  std::vector<Diagnostic> diagnostics;
};

ParseResult parse_scene(const ParseOptions& options);

// The tokens of a file as text, one a line: `line:column kind text`, directives not run. For --dump-tokens. Errors: what is no token is
// shown as `error` or `other`; nothing fails.
std::string dump_tokens(const std::string& file_name, std::string_view text);

}  // namespace lute
