#include "engine/texture/pattern/material_map.hpp"

namespace lute {

double evaluate(const MaterialMap& pattern, const dvec3& p, const PatternContext&) {
  const ImageMapping& mapping = pattern.mapping;
  const auto position = mapping.pixel_position(p);
  if (!position) return 0;
  const Image& image = *mapping.image;
  const int column = inner_index(static_cast<int>(position->x), image.width(), mapping.once);
  const int row = inner_index(static_cast<int>(position->y), image.height(), mapping.once);
  const int index = image.is_palette() ? image.index(column, row)
                                       : static_cast<int>(image.pixel(column, row).rgb.r * 255);
  // An index equal to the number of textures is left as it is: it selects the last.
  return index > pattern.texture_count ? index % pattern.texture_count : index;
}

}  // namespace lute
