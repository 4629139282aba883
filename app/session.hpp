// Everything that one run of lute does after its options are known.
#pragma once

#include "app/frame_job.hpp"

namespace lute {

// Carries out options.action. What goes wrong is told on the console; nothing is thrown.
ExitCode run_session(const RenderOptions& options);

// The same for options that cannot be read.
ExitCode report(const OptionError& error, Console& console);

}  // namespace lute
