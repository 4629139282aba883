// Everything that one run of lute does after its options are known.
#pragma once

#include "app/frame_job.hpp"

namespace lute {

// Carries out options.action. Throws std::runtime_error for what goes wrong outside of the scene.
ExitCode run_session(const RenderOptions& options);

}  // namespace lute
