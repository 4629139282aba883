#include "engine/texture/compiled_normal.hpp"

#include "engine/texture/texture_compiler.hpp"

namespace lute {
namespace {

// The corners of the tetrahedron at which the height of a pattern is sampled (chapter 50 §13.3).
const dvec3 kTetrahedron[4] = {{0.942809041, -0.333333333, 0},
                               {-0.471404521, -0.333333333, 0.816496581},
                               {-0.471404521, -0.333333333, -0.816496581},
                               {0, 1, 0}};

double slope_height(std::span<const SlopeMap::Entry> entries, double value) {
  const auto n = find_neighbours(entries, value);
  if (n.single()) return n.current->value.height;
  const auto& [h1, s1] = n.previous->value;
  const auto& [h2, s2] = n.current->value;
  const double t = n.t;
  return t * t * t * (s1 + s2 + 2 * (h1 - h2)) - t * t * (2 * s1 + s2 + 3 * (h1 - h2)) + t * s1 + h1;
}

}  // namespace

CompiledNormal::CompiledNormal(const Normal& normal, bool no_bump_scale, TextureCompiler& compiler)
    : pattern_(std::make_unique<CompiledPattern>(normal.body, compiler)),
      amount_(static_cast<double>(normal.amount)),
      accuracy_(static_cast<double>(normal.accuracy)),
      bump_scale_(!(normal.no_bump_scale || no_bump_scale)) {
  if (const auto* map = std::get_if<NormalMap>(&normal.map))
    for (const auto& entry : map->entries) normals_.push_back({entry.position, compiler.normal(entry.value, !bump_scale_)});
  if (const auto* map = std::get_if<SlopeMap>(&normal.map)) slopes_ = map->entries;
}

dvec3 CompiledNormal::perturb(const dvec3& normal, const dvec3& point, const SurfaceContext& surface) const {
  const dvec3 bent = bend(normal, point, surface);
  return bump_scale_ ? bent : glm::normalize(bent);  // carried out with its bump scale it is a unit already
}

dvec3 CompiledNormal::bend(const dvec3& normal, const dvec3& point, const SurfaceContext& surface) const {
  if (is_uv_mapping())
    return glm::normalize(normals_.front().normal->bend(normal, {surface.uv.x, surface.uv.y, 0}, surface));
  const dvec3 warped = pattern_->warp(point);
  dvec3 n = pattern_->carry_in(normal, bump_scale_);
  if (!normals_.empty())
    n = by_map(n, warped, surface);
  else if (pattern_->perturbs_normals())
    n = pattern_->perturb(n, amount_, warped, surface);
  else if (pattern_->pattern() != nullptr)
    n = by_slope(n, warped, surface);
  n = pattern_->carry_out(n, bump_scale_);
  // A map gives a unit also inside of another map; an average and a single pattern keep the length that they have without bump scale.
  return normals_.empty() || pattern_->is_average() || bump_scale_ ? n : glm::normalize(n);
}

dvec3 CompiledNormal::by_slope(dvec3 normal, const dvec3& warped, const SurfaceContext& surface) const {
  for (const dvec3& corner : kTetrahedron) {
    double height = pattern_->value(bounded_coordinates(warped + accuracy_ * corner), surface);
    if (!slopes_.empty()) height = slope_height(slopes_, height);
    normal -= 5 * amount_ * (0.02 / accuracy_) * height * corner;
  }
  return normal;
}

dvec3 CompiledNormal::by_map(const dvec3& normal, const dvec3& warped, const SurfaceContext& surface) const {
  if (pattern_->is_average()) {
    dvec3 sum{0};
    double total = 0;
    for (const NormalEntry& entry : normals_) {
      const double weight = static_cast<double>(entry.position);
      sum += weight * (entry.normal != nullptr ? entry.normal->bend(normal, warped, surface) : normal);
      total += weight;
    }
    return sum / total;
  }
  const auto n = find_neighbours(std::span<const NormalEntry>(normals_), pattern_->value(warped, surface));
  const auto one = [&](const NormalEntry* e) { return e->normal != nullptr ? e->normal->bend(normal, warped, surface) : normal; };
  const dvec3 current = one(n.current);
  return n.single() ? current : (1 - n.t) * one(n.previous) + n.t * current;
}

}  // namespace lute
