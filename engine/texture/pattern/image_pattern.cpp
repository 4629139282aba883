#include "engine/texture/pattern/image_pattern.hpp"

#include <algorithm>

namespace lute {

double evaluate(const ImagePattern& pattern, const dvec3& p, const PatternContext&) {
  const ImageMapping& mapping = pattern.mapping;
  const auto position = mapping.pixel_position(p);
  if (!position) return 0;
  const Image& image = *mapping.image;
  const Color color = interpolate_pixels(mapping, *position, [&](int column, int row) {
    const Image::Pixel pixel = image.pixel(column, row);
    return Color{pixel.rgb, 0, 1 - pixel.alpha};
  });
  const float value = !pattern.use_alpha ? grey(color.rgb) : image.keeps_alpha() ? color.transmit : color.rgb.r;
  return static_cast<double>(std::clamp(value, 0.0f, 1.0f));
}

}  // namespace lute
