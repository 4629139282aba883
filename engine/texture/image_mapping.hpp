// How an image lies in space: what image_map, bump_map, image_pattern and material_map have in common.
// Source: specification chapter 50 §11.1-2.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

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

// Weighs the pixels around a position. `fetch(column, row)` yields the value of a pixel inside the image: a float, a double or a Color.
template <class Fetch>
auto interpolate_pixels(const ImageMapping& mapping, const dvec2& position, const Fetch& fetch) {
  const int width = mapping.image->width(), height = mapping.image->height();
  const auto at = [&](int i, int j) { return fetch(inner_index(i, width, mapping.once), inner_index(j, height, mapping.once)); };
  using Value = decltype(fetch(0, 0));
  if (mapping.interpolate < 2) return at(static_cast<int>(position.x), static_cast<int>(position.y));
  const double u = position.x + 0.5, v = position.y + 0.5;
  const int i = static_cast<int>(u), j = static_cast<int>(v);
  const double p = u - i, q = v - j;
  // Colours and heights are weighed in single precision, numbers of textures in double.
  using Weight = std::conditional_t<std::is_same_v<Value, double>, double, float>;
  Value sum{};
  if (mapping.interpolate == 3) {
    const auto wx = bicubic_weights(p), wy = bicubic_weights(q);
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b)
        sum += at(i - 2 + a, j - 2 + b) * static_cast<Weight>(wx[static_cast<std::size_t>(a)] * wy[static_cast<std::size_t>(b)]);
    return sum;
  }
  std::array<double, 4> w{p * q, (1 - p) * q, p * (1 - q), (1 - p) * (1 - q)};
  if (mapping.interpolate == 4) w = distance_weights(p, q);
  sum += at(i, j) * static_cast<Weight>(w[0]);
  sum += at(i - 1, j) * static_cast<Weight>(w[1]);
  sum += at(i, j - 1) * static_cast<Weight>(w[2]);
  sum += at(i - 1, j - 1) * static_cast<Weight>(w[3]);
  return sum;
}

}  // namespace lute
