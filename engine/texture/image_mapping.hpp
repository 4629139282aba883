// How an image lies in space: what image_map, bump_map, image_pattern and material_map have in common.
// Source: specification chapter 50 §11.1-2.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "engine/image/color.hpp"
#include "engine/image/image.hpp"
#include "engine/math/vec.hpp"

namespace lute {

struct ImageMapping {
  ImagePtr image;
  bool once = false;
  int map_type = 0;     // 1 spherical, 2 cylindrical, 5 torus, everything else planar
  int interpolate = 0;  // 2 bilinear, 3 bicubic, 4 normalised distance
  bool use_index = false;
  dvec2 repeat{1, 1}, offset{0, 0};  // in image sizes

  // Pixel coordinates of a point: 0 <= u < width to the right, 0 <= v < height downward. Nothing outside a `once` image.
  std::optional<dvec2> pixel_position(const dvec3& point) const;
};

// `filter all`, `transmit all` and their forms for one palette entry.
struct ImageTransparency {
  std::optional<float> filter_all, transmit_all;
  std::vector<std::pair<int, float>> filter_of, transmit_of;  // palette index, value
};

// Weights of the four pixels of a row, from the left, at fraction p; of the four around a position (fractions p, q).
std::array<double, 4> bicubic_weights(double p);
std::array<double, 4> distance_weights(double p, double q);

// Column or row `i` of `size`, which may lie a few pixels outside: clamped to the edge of a `once` image, else wrapped.
inline int inner_index(int i, int size, bool once) {
  if (once) return std::clamp(i, 0, size - 1);
  return i >= 0 && i < size ? i : ((i % size) + size) % size;
}

// The sum of weighted pixels, in double precision; colours are rounded to single precision once, at the end, as in the reference.
template <class Value>
class PixelSum;
template <>
class PixelSum<double> {
 public:
  void add(double value, double weight) { sum_ += value * weight; }
  double value() const { return sum_; }

 private:
  double sum_ = 0;
};
template <>
class PixelSum<Color> {
 public:
  void add(const Color& c, double weight) {
    const float parts[] = {c.rgb.r, c.rgb.g, c.rgb.b, c.filter, c.transmit};
    for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += static_cast<double>(parts[i]) * weight;
  }
  Color value() const {
    const auto part = [&](std::size_t i) { return static_cast<float>(sum_[i]); };
    return {{part(0), part(1), part(2)}, part(3), part(4)};
  }

 private:
  std::array<double, 5> sum_{};
};

// Weighs the pixels around a position. `fetch(column, row)` yields the value of a pixel inside the image: a double or a Color.
template <class Fetch>
auto interpolate_pixels(const ImageMapping& mapping, const dvec2& position, const Fetch& fetch) {
  const int width = mapping.image->width(), height = mapping.image->height();
  const auto at = [&](int i, int j) { return fetch(inner_index(i, width, mapping.once), inner_index(j, height, mapping.once)); };
  if (mapping.interpolate < 2) return at(static_cast<int>(position.x), static_cast<int>(position.y));
  const double u = position.x + 0.5, v = position.y + 0.5;
  const int i = static_cast<int>(u), j = static_cast<int>(v);
  const double p = u - i, q = v - j;
  PixelSum<decltype(fetch(0, 0))> sum;
  if (mapping.interpolate == 3) {
    const auto wx = bicubic_weights(p), wy = bicubic_weights(q);
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b)
        sum.add(at(i - 2 + a, j - 2 + b), wx[static_cast<std::size_t>(a)] * wy[static_cast<std::size_t>(b)]);
    return sum.value();
  }
  std::array<double, 4> w{p * q, (1 - p) * q, p * (1 - q), (1 - p) * (1 - q)};
  if (mapping.interpolate == 4) w = distance_weights(p, q);
  sum.add(at(i, j), w[0]);
  sum.add(at(i - 1, j), w[1]);
  sum.add(at(i, j - 1), w[2]);
  sum.add(at(i - 1, j - 1), w[3]);
  return sum.value();
}

}  // namespace lute
