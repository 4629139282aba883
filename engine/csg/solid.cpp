#include "engine/csg/solid.hpp"

namespace lute {

bool Solid::nearest(const Ray& ray, Interval range, RayKind kind, Hit& hit) const {
  // Reused between calls: a hit list is short-lived, allocating it for every ray is not. Nested calls use its tail.
  thread_local Hits found;
  const std::size_t first = found.size();
  hits(ray, range, kind, found);
  bool any_found = false;
  for (std::size_t i = found.size(); i > first; --i) {
    const Hit& candidate = found[i - 1];
    if (any_found && !(candidate.t < hit.t)) continue;
    hit = candidate;
    any_found = true;
  }
  found.resize(first);
  return any_found;
}

bool Solid::any(const Ray& ray, Interval range, RayKind kind) const {
  Hit hit;
  return nearest(ray, range, kind, hit);
}

}  // namespace lute
