// What --explain says about sampling: how often a pixel is sampled, and what is kept meanwhile. The decisions are those of
// Antialiasing and FocalBlur, which the renderer asks for itself.
#pragma once

#include "engine/plan/render_plan.hpp"
#include "engine/render/antialias.hpp"

namespace lute {

// Appends buffers, passes and tables. `estimate_error`: --stats asks for it.
void plan_sampling(const Scene& scene, const Antialiasing& antialiasing, bool estimate_error, RenderPlan& plan);

}  // namespace lute
