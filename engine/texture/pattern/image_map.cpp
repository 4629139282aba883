#include "engine/texture/pattern/image_map.hpp"

#include <algorithm>

namespace lute {
namespace {

// The value written for a palette entry; the last one written counts.
std::optional<float> value_of(const std::vector<std::pair<int, float>>& values, int index) {
  for (auto it = values.rbegin(); it != values.rend(); ++it)
    if (it->first == index) return it->second;
  return std::nullopt;
}

Color pixel_color(const ImageMap& pattern, int column, int row) {
  const Image& image = *pattern.mapping.image;
  const ImageTransparency& t = pattern.transparency;
  const Image::Pixel pixel = image.pixel(column, row);
  Color color{pixel.rgb, 0, 1 - pixel.alpha};
  if (image.is_palette()) {
    const int index = image.index(column, row);
    if (t.filter_all) color.filter = *t.filter_all;
    if (t.transmit_all) color.transmit = *t.transmit_all;
    color.filter = value_of(t.filter_of, index).value_or(color.filter);
    color.transmit = value_of(t.transmit_of, index).value_or(color.transmit);
  } else {
    color.filter += t.filter_all.value_or(0.0f);
    color.transmit += t.transmit_all.value_or(0.0f);
  }
  return color;
}

}  // namespace

bool map_color(const ImageMap& pattern, const dvec3& p, Color& color) {
  const auto position = pattern.mapping.pixel_position(p);
  if (!position) {
    color = {Rgb(1), 0, 1};
    return false;
  }
  color = interpolate_pixels(pattern.mapping, *position, [&](int column, int row) { return pixel_color(pattern, column, row); });
  if (pattern.mapping.image->premultiplied()) {
    const float alpha = 1 - color.transmit;
    if (static_cast<double>(alpha) > kEpsilon) color.rgb *= 1 / alpha;
  }
  return true;
}

double evaluate(const ImageMap& pattern, const dvec3& p, const PatternContext&) {
  Color color;
  return map_color(pattern, p, color) ? static_cast<double>(grey(color.rgb)) : 0;
}

bool is_opaque(const ImageMap& pattern) {
  const ImageTransparency& t = pattern.transparency;
  const auto some = [](const std::pair<int, float>& v) { return v.second != 0; };
  return !pattern.mapping.once && !pattern.mapping.image->has_alpha() && t.filter_all.value_or(0.0f) == 0 && t.transmit_all.value_or(0.0f) == 0 &&
         std::none_of(t.filter_of.begin(), t.filter_of.end(), some) &&
         std::none_of(t.transmit_of.begin(), t.transmit_of.end(), some);
}

}  // namespace lute
