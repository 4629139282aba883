// One frame from the scene's text to the file.
#pragma once

#include "app/console.hpp"
#include "app/interrupt.hpp"
#include "app/statistics.hpp"
#include "engine/build/built_scene.hpp"
#include "parser/options/frames.hpp"

namespace lute {

enum class ExitCode : int { kDone = 0, kFailed = 1, kUsage = 2, kInterrupted = kInterruptedExit };

// Parses the scene of a frame and tells what is wrong with it. `text` replaces the file's content (standard input).
ParseResult parse_frame(const RenderOptions& options, const Frame& frame, const std::optional<std::string>& text,
                        Console& console);

// Parses, builds, renders and writes. Throws std::runtime_error for what goes wrong outside of the scene.
ExitCode render_frame(const RenderOptions& options, const Frame& frame, const std::optional<std::string>& text,
                      Console& console);

// What the renderer builds for these options.
BuildOptions build_options(const RenderOptions& options);

}  // namespace lute
