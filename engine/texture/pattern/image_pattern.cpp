#include "engine/texture/pattern/image_pattern.hpp"

#include <algorithm>

namespace lute {

double evaluate(const ImagePattern& pattern, const dvec3& p, const PatternContext&) {
  const ImageMapping& mapping = pattern.mapping;
  const auto position = mapping.pixel_position(p);
  if (!position) return 0;
  const Image& image = *mapping.image;
  const float value = interpolate_pixels(mapping, *position, [&](int column, int row) {
    const Image::Pixel pixel = image.pixel(column, row);
    if (pattern.use_alpha) return image.keeps_alpha() ? 1 - pixel.alpha : pixel.rgb.r;
    return grey(pixel.rgb);
  });
  return static_cast<double>(std::clamp(value, 0.0f, 1.0f));
}

}  // namespace lute
