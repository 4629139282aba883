#include "engine/math/aabb.hpp"

#include <glm/common.hpp>

namespace lute {

Aabb Aabb::infinite() {
  const double inf = std::numeric_limits<double>::infinity();
  return {dvec3(-inf), dvec3(inf)};
}

bool Aabb::empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }

bool Aabb::is_finite() const {
  const double max = std::numeric_limits<double>::max();
  return lo.x >= -max && lo.y >= -max && lo.z >= -max && hi.x <= max && hi.y <= max && hi.z <= max;
}

bool Aabb::contains(const dvec3& p) const {
  return lo.x <= p.x && p.x <= hi.x && lo.y <= p.y && p.y <= hi.y && lo.z <= p.z && p.z <= hi.z;
}

double Aabb::volume() const {
  if (empty()) return 0;
  const dvec3 d = hi - lo;
  return d.x * d.y * d.z;
}

double Aabb::half_area() const {
  if (empty()) return 0;
  const dvec3 d = hi - lo;
  return d.x * d.y + d.y * d.z + d.z * d.x;
}

void Aabb::join(const dvec3& p) {
  lo = glm::min(lo, p);
  hi = glm::max(hi, p);
}

void Aabb::join(const Aabb& b) {
  lo = glm::min(lo, b.lo);
  hi = glm::max(hi, b.hi);
}

Aabb Aabb::intersection(const Aabb& b) const { return {glm::max(lo, b.lo), glm::min(hi, b.hi)}; }

}  // namespace lute
