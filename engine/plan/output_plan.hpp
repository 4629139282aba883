// What --explain says about writing the picture. The decisions are those of encode(), which asks for them itself.
#pragma once

#include "engine/output/output_settings.hpp"
#include "engine/plan/render_plan.hpp"

namespace lute {

// Appends tables; width and height of the picture in pixels. `to_file` false: none is written.
void plan_output(const OutputSettings& output, bool to_file, int width, int height, RenderPlan& plan);

}  // namespace lute
