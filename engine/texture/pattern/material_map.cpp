#include "engine/texture/pattern/material_map.hpp"

#include "engine/math/rounding.hpp"

namespace lute {

double evaluate(const MaterialMap& pattern, const dvec3& p, const PatternContext&) {
  const ImageMapping& mapping = pattern.mapping;
  const auto position = mapping.pixel_position(p);
  if (!position) return 0;
  const Image& image = *mapping.image;
  const double number = interpolate_pixels(mapping, *position, [&](int column, int row) {
    if (image.is_palette()) return static_cast<double>(image.index(column, row));
    return static_cast<double>(image.pixel(column, row).rgb.r * 255);
  });
  const int index = static_cast<int>(bounded(number, 1e9));
  // An index equal to the number of textures is left as it is: it selects the last.
  return index > pattern.texture_count ? index % pattern.texture_count : index;
}

}  // namespace lute
