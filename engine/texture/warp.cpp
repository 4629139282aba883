#include "engine/texture/warp.hpp"

#include <algorithm>
#include <cmath>

#include "engine/texture/noise.hpp"

namespace lute {
namespace {

dvec3 orient(const dvec3& mapped, const dvec3& o) {
  if (o == dvec3(0, 0, 1)) return mapped;
  return {o.x * mapped.z + o.y * mapped.x + o.z * mapped.x, o.x * mapped.y - o.y * mapped.z + o.z * mapped.y,
          -o.x * mapped.x + o.y * mapped.y + o.z * mapped.z};
}

double stretch(double distance, double exponent) { return exponent == 0 ? 1 : std::pow(distance, exponent); }

dvec3 warp(const Transform& w, const dvec3& p) { return w.inverse_point(p); }
dvec3 warp(const Turbulence& w, const dvec3& p) { return p + w.amount * vector_turbulence(p, w); }

dvec3 warp(const RepeatWarp& w, const dvec3& p) {
  const int a = w.axis;
  const double width = static_cast<double>(w.width);
  // How many widths, and how far they are, is in single precision.
  const float widths = static_cast<float>(std::floor(p[a] / width));
  const double n = static_cast<double>(widths);
  dvec3 q = p;
  q[a] = p[a] - static_cast<double>(widths * w.width);
  if (std::fmod(n, 2.0) != 0) {
    q *= w.flip;
    if (w.flip[a] < 0) q[a] += width;
  }
  return q + n * w.offset;
}

dvec3 warp(const BlackHoleWarp& w, const dvec3& p) {
  if (w.type != 0) return p;
  dvec3 center = w.center;
  if (w.repeat) {
    dvec3 block{0};
    for (int i = 0; i < 3; ++i)
      if ((*w.repeat)[i] >= kEpsilon) block[i] = std::floor(p[i] / (*w.repeat)[i]);
    if (w.turbulence != dvec3(0)) {
      const std::uint32_t h = hash3(cell_number(block.x), cell_number(block.y), cell_number(block.z));
      center += dvec3(random_table(h), random_table(h + 1), random_table(h + 2)) * w.turbulence;
    }
    center += *w.repeat * block;
  }
  const dvec3 delta = p - center;
  const double d = glm::length(delta);
  if (d >= w.radius) return p;
  const double a = std::min(1.0, std::pow((w.radius - d) / w.radius, w.falloff) * w.strength);
  return p + (w.inverse ? -a : a) * delta;
}

dvec3 warp(const PlanarWarp& w, const dvec3& p) { return orient({p.x, p.y, w.offset}, w.orientation); }

dvec3 warp(const CylindricalWarp& w, const dvec3& p) {
  const double length = std::sqrt(p.x * p.x + p.z * p.z);
  if (length == 0) return p;
  return orient({turn_about_y(p.x, p.z) * stretch(length, w.dist_exp), p.y, length}, w.orientation);
}

dvec3 warp(const SphericalWarp& w, const dvec3& p) {
  const double r = glm::length(p);
  if (r == 0) return p;
  const double s = stretch(r, w.dist_exp);
  const double u = p.x == 0 && p.z == 0 ? 0 : turn_about_y(p.x, p.z);
  return orient({u * s, (0.5 + std::asin(p.y / r) / kPi) * s, r}, w.orientation);
}

dvec3 warp(const ToroidalWarp& w, const dvec3& p) {
  const double length = std::sqrt(p.x * p.x + p.z * p.z);
  if (length == 0) return p;
  const RingPosition ring = turn_about_ring(p, w.major_radius);
  const double s = stretch(ring.distance, w.dist_exp);
  return orient({turn_about_y(p.x, p.z) * s, ring.turn * s, ring.distance}, w.orientation);
}

dvec3 warp(const CubicWarp&, const dvec3& p) {
  const double x = std::fabs(p.x), y = std::fabs(p.y), z = std::fabs(p.z), m = std::max({x, y, z});
  const auto unit = [m](double t) { return (t / m + 1) / 2; };
  if (p.x >= 0 && x >= y && x >= z) return {0.75 - unit(p.z) / 4, 1.0 / 3 + unit(p.y) / 3, m};
  if (p.y >= 0 && y >= x && y >= z) return {0.25 + unit(p.x) / 4, 1 - unit(p.z) / 3, m};
  if (p.z >= 0 && z >= x && z >= y) return {0.25 + unit(p.x) / 4, 1.0 / 3 + unit(p.y) / 3, m};
  if (p.x < 0 && x >= y && x >= z) return {unit(p.z) / 4, 1.0 / 3 + unit(p.y) / 3, m};
  if (p.y < 0 && y >= x && y >= z) return {0.25 + unit(p.x) / 4, unit(p.z) / 3, m};
  return {1 - unit(p.x) / 4, 1.0 / 3 + unit(p.y) / 3, m};
}

}  // namespace

double turn_about_y(double x, double z) {
  if (z == 0) return x > 0 ? 0 : 0.5;
  const double angle = std::acos(x / std::sqrt(x * x + z * z));
  return (z < 0 ? 2 * kPi - angle : angle) / (2 * kPi);
}

RingPosition turn_about_ring(const dvec3& p, double major_radius) {
  const double a = std::sqrt(p.x * p.x + p.z * p.z) - major_radius, m = std::sqrt(a * a + p.y * p.y);
  const double phi = std::acos(-a / m);
  return {(p.y > 0 ? 2 * kPi - phi : phi) / (2 * kPi), m};
}

dvec3 apply_warps(const WarpChain& chain, dvec3 point, bool skip_classic_turbulence) {
  if (const auto* only = chain.size() == 1 ? std::get_if<Transform>(&chain.front()) : nullptr)  // most often
    point = only->inverse_point(point);
  else for (const Warp& w : chain) {
    if (skip_classic_turbulence && std::holds_alternative<ClassicTurbulence>(w)) continue;
    point = std::visit([&](const auto& each) { return warp(each, point); }, w);
  }
  return point;
}

void prepend_transform(WarpChain& chain, const Transform& transform) {
  if (!chain.empty())
    if (auto* first = std::get_if<Transform>(&chain.front())) {
      *first = first->then(transform);
      return;
    }
  chain.insert(chain.begin(), Warp(transform));
}

}  // namespace lute
