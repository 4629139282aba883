#include "engine/shape/shape.hpp"

namespace lute {

bool Shape::nearest(const Ray& ray, Interval range, ShapeHit& hit) const {
  // Reused between calls: a hit list is short-lived, allocating it for every ray is not.
  thread_local ShapeHits found;
  const std::size_t first = found.size();
  hits(ray, range, found);
  bool any_found = false;
  for (std::size_t i = found.size(); i > first; --i) {
    const ShapeHit& candidate = found[i - 1];
    if (any_found && !(candidate.t < hit.t)) continue;
    hit = candidate;
    any_found = true;
  }
  found.resize(first);
  return any_found;
}

bool Shape::any(const Ray& ray, Interval range) const {
  ShapeHit hit;
  return nearest(ray, range, hit);
}

dvec2 Shape::uv(const ShapeHit&, const dvec3& point) const { return {point.x, point.y}; }

void Shape::textures(const ShapeHit&, const dvec3&, std::vector<TextureWeight>& out) const {
  out.push_back({TextureWeight::kObjectTexture, 1});
}

}  // namespace lute
