#include "engine/plan/output_plan.hpp"

#include "engine/output/encode.hpp"

namespace lute {

void plan_output(const OutputSettings& output, bool to_file, int width, int height, RenderPlan& plan) {
  const bool codes = to_file && encodes_by_table(output, width, height);
  const char* reason = "left out: dithered, of more than 8 bits, or too small to be worth it";
  if (codes) reason = "needed because the codes of the file's gamma curve are looked up";
  else if (!to_file) reason = "left out: no file is written";
  else if (traits_of(output.format).linear_light) reason = "left out: the file holds light, not codes";
  plan.items.push_back({"tables", "codes of colours", codes, reason, {}});
}

}  // namespace lute
