#include "engine/texture/pattern/material_map.hpp"

#include "engine/math/rounding.hpp"

namespace lute {

namespace {

constexpr double kNoIndex = -1;  // of a pixel of an image without a palette

}  // namespace

double evaluate(const MaterialMap& pattern, const dvec3& p, const PatternContext&) {
  const ImageMapping& mapping = pattern.mapping;
  const auto position = mapping.pixel_position(p);
  if (!position) return 0;
  const Image& image = *mapping.image;
  // The reference weighs indices and colours side by side, and then sees by the index whether there is a palette. Where the weights of an
  // image without one add up to less than 1, by their rounding, -1 becomes the index 0.
  const double mean_index = interpolate_pixels(mapping, *position, [&](int column, int row) {
    return image.is_palette() ? static_cast<double>(image.index(column, row)) : kNoIndex;
  });
  int index = static_cast<int>(mean_index);
  if (index == kNoIndex) {
    const double red =
        interpolate_pixels(mapping, *position, [&](int column, int row) { return static_cast<double>(image.pixel(column, row).rgb.r); });
    index = static_cast<int>(bounded(static_cast<double>(static_cast<float>(red) * 255), 1e9));
  }
  // An index equal to the number of textures is left as it is: it selects the last.
  return index > pattern.texture_count ? index % pattern.texture_count : index;
}

}  // namespace lute
