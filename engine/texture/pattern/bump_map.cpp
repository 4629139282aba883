#include "engine/texture/pattern/bump_map.hpp"

#include <cmath>

namespace lute {
namespace {

double height(const ImageMapping& mapping, const dvec2& position) {
  const Image& image = *mapping.image;
  // Indices are whole numbers between pixels too.
  const auto index = [&](int column, int row) { return static_cast<double>(image.index(column, row)); };
  if (mapping.use_index && image.is_palette()) return std::floor(interpolate_pixels(mapping, position, index));
  const Color mean = interpolate_pixels(mapping, position, [&](int column, int row) { return Color{image.pixel(column, row).rgb}; });
  return static_cast<double>(grey(mean.rgb));
}

}  // namespace

double evaluate(const BumpMap& pattern, const dvec3& p, const PatternContext&) {
  const auto position = pattern.mapping.pixel_position(p);
  return position ? height(pattern.mapping, *position) : 0;
}

dvec3 perturb(const BumpMap& pattern, const dvec3& normal, double amount, const dvec3& p, const PatternContext&) {
  const ImageMapping& mapping = pattern.mapping;
  const auto position = mapping.pixel_position(p);
  if (!position) return normal;
  const double w = mapping.image->width(), h = mapping.image->height();
  // The heights here, and one pixel below to the left and to the right, wrapped around the image.
  const double left = position->x - 1 < 0 ? position->x - 1 + w : position->x - 1;
  const double right = position->x + 1 >= w ? position->x + 1 - w : position->x + 1;
  const double below = position->y + 1 >= h ? position->y + 1 - h : position->y + 1;
  const double h1 = amount * height(mapping, *position);
  const double h2 = amount * height(mapping, {left, below}), h3 = amount * height(mapping, {right, below});
  const dvec3 bump = glm::normalize(dvec3(h2 - h3, 2, 2 * h1 - h2 - h3));

  dvec3 y = normal, x = glm::cross(normal, dvec3(0, 1, 0));
  const double length = glm::length(x);
  if (length < kEpsilon) {
    y = {0, normal.y < 0 ? -1 : 1, 0};
    x = {1, 0, 0};
  } else {
    x /= length;
  }
  const dvec3 z = glm::normalize(glm::cross(x, y));
  return bump.x * x + bump.y * y - bump.z * z;
}

}  // namespace lute
