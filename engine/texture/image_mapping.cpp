#include "engine/texture/image_mapping.hpp"

#include <cmath>

#include "engine/texture/warp.hpp"

namespace lute {
namespace {

// Before offset and wrapping: u to the right, v upward.
std::optional<dvec2> mapped(const ImageMapping& mapping, const dvec3& p, double u0, double v0) {
  switch (mapping.map_type) {
    case 1: {
      const double r = glm::length(p);
      if (r == 0) return std::nullopt;
      const double turn = p.x == 0 && p.z == 0 ? 0 : turn_about_y(p.x, p.z);
      return dvec2(turn * u0, (0.5 + std::asin(p.y / r) / kPi) * v0);
    }
    case 2:
      if ((p.x == 0 && p.z == 0) || (mapping.once && (p.y < 0 || p.y > 1))) return std::nullopt;
      return dvec2(turn_about_y(p.x, p.z) * u0, std::fmod(p.y * v0, v0));
    case 5:
      if (p.x == 0 && p.z == 0) return std::nullopt;
      return dvec2(turn_about_y(p.x, p.z) * u0, turn_about_ring(p, 1).turn * v0);
    default:
      if (mapping.once && (p.x < 0 || p.x > 1 || p.y < 0 || p.y > 1)) return std::nullopt;
      return dvec2(std::fmod(p.x * u0, u0), std::fmod(p.y * v0, v0));
  }
}

// C's remainder brought into [0, size).
double wrapped(double v, double size) {
  const double r = std::fmod(v, size);
  return r < 0 ? r + size : r;
}

}  // namespace

std::optional<dvec2> ImageMapping::pixel_position(const dvec3& point) const {
  const double w = image->width(), h = image->height();
  // The repeated size is kept in single precision.
  const auto position = mapped(*this, point, static_cast<double>(static_cast<float>(w * repeat.x)),
                               static_cast<double>(static_cast<float>(h * repeat.y)));
  if (!position) return std::nullopt;
  const double u = position->x - offset.x * w + kEpsilon, v = position->y - offset.y * h + kEpsilon;
  // Written so that a coordinate that is not a number counts as outside, too.
  if (once && !(u >= 0 && u < w && v >= 0 && v < h)) return std::nullopt;
  const dvec2 result(wrapped(u, w), wrapped(-v, h));
  if (!(result.x <= w && result.y <= h)) return std::nullopt;
  return result;
}

std::array<double, 4> bicubic_weights(double p) {
  const double q = 1 - p;
  return {-0.5 * p * q * q, 0.5 * q * (q * (3 * p + 1) + 1), 0.5 * p * (p * (3 * q + 1) + 1), -0.5 * q * p * p};
}

std::array<double, 4> distance_weights(double p, double q) {
  const double p1 = 1 - p, q1 = 1 - q;
  std::array<double, 4> w{p1 * p1 + q1 * q1, p * p + q1 * q1, p1 * p1 + q * q, p * p + q * q};  // squared distances
  // Exactly on a pixel's centre that pixel alone counts.
  for (std::size_t i = 0; i < 4; ++i)
    if (w[i] == 0) {
      w = {0, 0, 0, 0};
      w[i] = 1;
      return w;
    }
  for (double& each : w) each = 1 / each;
  const double sum = w[0] + w[1] + w[2] + w[3];
  for (double& each : w) each /= sum;
  return w;
}

}  // namespace lute
