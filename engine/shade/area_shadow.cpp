// Soft shadows: the grid of an area light, refined where its corners differ (§10.4).
#include <cmath>
#include <limits>

#include "engine/light/area.hpp"
#include "engine/shade/shader.hpp"

namespace lute {

struct Shader::AreaGrid {
  const Surface& surface;
  const BuiltLight& light;
  AreaAxes axes;
  Rgb color;
  ScratchBlock<Rgb> samples;  // NaN where not yet traced
};

namespace {

// More difference than this between neighbouring corners asks for more samples.
constexpr float kThreshold = 0.1f;

bool differ(Rgb a, Rgb b) { return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) > kThreshold; }

}  // namespace

Rgb Shader::area_shadow(const Surface& surface, const BuiltLight& light, const dvec3& to_center, Rgb color) {
  const AreaLight& area = *light.area;
  const auto count = static_cast<std::size_t>(area.size1) * static_cast<std::size_t>(area.size2);
  AreaGrid grid{surface, light, area_axes(light, to_center), color, ScratchBlock<Rgb>(scratch_.area_samples, count)};
  for (std::size_t i = 0; i < count; ++i) grid.samples[i] = Rgb(std::numeric_limits<float>::quiet_NaN());
  return area_region(grid, {0, 0, area.size1 - 1, area.size2 - 1, 0});
}

// Each grid place is traced at most once for a point.
Rgb Shader::area_sample_light(AreaGrid& grid, int u, int v) {
  const AreaLight& area = *grid.light.area;
  const auto index = static_cast<std::size_t>(u) + static_cast<std::size_t>(v) * static_cast<std::size_t>(area.size1);
  if (!std::isnan(grid.samples[index].r)) return grid.samples[index];
  const double du = area.jitter ? context_.random.next() - 0.5 : 0;
  const double dv = area.jitter ? context_.random.next() - 0.5 : 0;
  const dvec3 sample = grid.light.location + area_offset(area, grid.axes, u + du, v + dv);
  const Rgb light = shadowed(grid.surface, grid.light, path_to(grid.light, sample, grid.surface.hit.point), grid.color);
  grid.samples[index] = light;
  return light;
}

Rgb Shader::area_region(AreaGrid& grid, const AreaRegion& r) {
  Rgb corner[4] = {area_sample_light(grid, r.u1, r.v1), area_sample_light(grid, r.u2, r.v1), area_sample_light(grid, r.u1, r.v2),
                   area_sample_light(grid, r.u2, r.v2)};
  if (r.u2 - r.u1 > 1 || r.v2 - r.v1 > 1) {
    const bool refine = r.level < grid.light.area->adaptive || differ(corner[0], corner[1]) || differ(corner[1], corner[3]) ||
                        differ(corner[3], corner[2]) || differ(corner[2], corner[0]);
    if (refine) {
      const int u_low = (r.u1 + r.u2) / 2, u_high = (r.u1 + r.u2 + 1) / 2;
      const int v_low = (r.v1 + r.v2) / 2, v_high = (r.v1 + r.v2 + 1) / 2;
      corner[0] = area_region(grid, {r.u1, r.v1, u_low, v_low, r.level + 1});
      corner[1] = area_region(grid, {u_high, r.v1, r.u2, v_low, r.level + 1});
      corner[2] = area_region(grid, {r.u1, v_high, u_low, r.v2, r.level + 1});
      corner[3] = area_region(grid, {u_high, v_high, r.u2, r.v2, r.level + 1});
    }
  }
  return (corner[0] + corner[1] + corner[2] + corner[3]) * 0.25f;
}

}  // namespace lute
