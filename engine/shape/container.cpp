#include "engine/shape/container.hpp"

#include <cmath>
#include <utility>

namespace lute {

Aabb Container::box() const {
  return is_sphere ? Aabb{center - dvec3(std::abs(radius)), center + dvec3(std::abs(radius))} : Aabb{lo, hi};
}

namespace {

// A search between depths that are no numbers would not end: nothing is seen of a container of infinite size.
bool is_finite(Interval depths) { return std::isfinite(depths.lo) && std::isfinite(depths.hi); }

}  // namespace

bool Container::contains(const dvec3& p) const {
  return is_sphere ? glm::length(p - center) <= std::abs(radius) : Aabb{lo, hi}.contains(p);
}

bool Container::cross(const Ray& ray, Passage& passage) const {
  if (is_sphere) {
    const double a = glm::dot(ray.direction, ray.direction);
    const dvec3 w = center - ray.origin;
    const double b = glm::dot(w, ray.direction) / a;
    const dvec3 apart = w - b * ray.direction;
    const double h = (radius * radius - glm::dot(apart, apart)) / a;
    if (!(h > 0)) return false;
    passage = {{b - std::sqrt(h), b + std::sqrt(h)}, kRound, kRound};
    return is_finite(passage.depths);
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  passage = {{-kInfinity, kInfinity}, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const double p = ray.origin[axis];
    const double d = ray.direction[axis];
    if (d == 0) {
      if (p < lo[axis] || p > hi[axis]) return false;
      continue;
    }
    double near = (lo[axis] - p) / d;
    double far = (hi[axis] - p) / d;
    auto near_face = static_cast<std::uint32_t>(2 * axis);
    std::uint32_t far_face = near_face + 1;
    if (near > far) {
      std::swap(near, far);
      std::swap(near_face, far_face);
    }
    if (near > passage.depths.lo) {
      passage.depths.lo = near;
      passage.enter = near_face;
    }
    if (far < passage.depths.hi) {
      passage.depths.hi = far;
      passage.leave = far_face;
    }
  }
  return !passage.depths.empty() && is_finite(passage.depths);
}

dvec3 Container::normal(std::uint32_t face, const dvec3& p) const {
  if (face == kRound) return (p - center) / radius;
  dvec3 n(0);
  n[static_cast<int>(face / 2)] = face % 2 ? 1 : -1;
  return n;
}

double depth_accuracy(double accuracy, const Container& container, const Transform& to_world) {
  constexpr double kSmall = 0.05;  // share of the container
  const auto size = [](const Aabb& box) { return glm::length(box.hi - box.lo); };
  const double world = size(to_world.box(container.box()));
  return accuracy < kSmall * world ? accuracy : accuracy * world / size(container.box());
}

}  // namespace lute
