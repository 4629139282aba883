#include "engine/shape/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/math/polynomial.hpp"
#include "engine/shape/glyph_outline.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

constexpr Interval kPiece{-1e-10, 1 + 1e-10};

bool in_outline(const GlyphOutline& glyph, const dvec2& p) {
  if (p.x < glyph.lo.x || p.x > glyph.hi.x || p.y < glyph.lo.y || p.y > glyph.hi.y) return false;
  bool odd = false;
  for (const OutlinePiece& e : glyph.pieces) {
    if ((e.p0.y > p.y) == (e.p2.y > p.y)) continue;
    const std::array<double, 3> y{e.p0.y - p.y, 2 * (e.p1.y - e.p0.y), e.p0.y - 2 * e.p1.y + e.p2.y};
    const Roots<2> roots = solve_quadratic(y, {0, 1});
    odd ^= e.at(roots.count > 0 ? roots.t[0] : 0.5).x > p.x;
  }
  return odd;
}

// A hit on a wall keeps its normal.
class Lettering final : public ScannedShape<Lettering> {
 public:
  Lettering(std::vector<GlyphOutline> glyphs, double depth, const SharedTransform& to_world)
      : glyphs_(std::move(glyphs)), depth_(depth), to_world_(to_world) {}

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    const Ray local = to_world_->inverse_ray(ray);
    const double slack = slack_of(local);
    for (const GlyphOutline& glyph : glyphs_) {
      const Interval within = box_crossing(local, glyph, slack);
      if (within.empty() || within.lo > range.hi || within.hi < range.lo) continue;
      if (scan_caps(glyph, local, sink) || scan_walls(glyph, local, within, slack, sink)) return;
    }
  }

  Aabb bounds() const override {
    Aabb box;
    for (const GlyphOutline& glyph : glyphs_) {
      box.join(dvec3(glyph.lo, 0));
      box.join(dvec3(glyph.hi, depth_));
    }
    return to_world_->box(box);
  }
  bool inside(const dvec3& point) const override {
    const dvec3 p = to_world_->inverse_point(point);
    if (p.z < 0 || p.z > depth_) return false;
    return std::ranges::any_of(glyphs_, [&](const GlyphOutline& glyph) { return in_outline(glyph, dvec2(p.x, p.y)); });
  }
  dvec3 normal(const ShapeHit& hit, const dvec3&) const override {
    return glm::normalize(to_world_->normal({hit.data[0], hit.data[1], hit.data[2]}));
  }

 private:
  // How far the line may be off its place by rounding, in ems.
  static double slack_of(const Ray& ray) {
    return 1e-9 * (1 + std::max({std::abs(ray.origin.x), std::abs(ray.origin.y), std::abs(ray.origin.z)}));
  }

  // Where the line passes the glyph's box, a little enlarged.
  Interval box_crossing(const Ray& ray, const GlyphOutline& glyph, double slack) const {
    const dvec3 lo = dvec3(glyph.lo, 0) - dvec3(slack);
    const dvec3 hi = dvec3(glyph.hi, depth_) + dvec3(slack);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Interval line{-kInfinity, kInfinity};
    for (int axis = 0; axis < 3; ++axis) {
      const double p = ray.origin[axis];
      const double d = ray.direction[axis];
      if (d == 0) {
        if (p < lo[axis] || p > hi[axis]) return {kInfinity, -kInfinity};
        continue;
      }
      const double t0 = (lo[axis] - p) / d;
      const double t1 = (hi[axis] - p) / d;
      line = {std::max(line.lo, std::min(t0, t1)), std::min(line.hi, std::max(t0, t1))};
    }
    return line;
  }

  // These two return true if the sink needs no other hit at all.
  template <class Sink>
  bool scan_caps(const GlyphOutline& glyph, const Ray& ray, Sink& sink) const {
    if (ray.direction.z == 0) return false;
    // Without depth the two coincide, and the last one, the back, is what is seen.
    for (const bool back : {false, true}) {
      const double t = ((back ? depth_ : 0) - ray.origin.z) / ray.direction.z;
      const dvec3 p = ray.at(t);
      if (!in_outline(glyph, dvec2(p.x, p.y))) continue;
      if (sink(t, 0, std::array<double, 3>{0, 0, back ? 1.0 : -1.0}) && !depth_matters<Sink>()) return true;
    }
    return false;
  }

  template <class Sink>
  bool scan_walls(const GlyphOutline& glyph, const Ray& ray, Interval within, double slack, Sink& sink) const {
    const dvec2 o(ray.origin.x, ray.origin.y);
    const dvec2 d(ray.direction.x, ray.direction.y);
    if (glm::dot(d, d) <= kEpsilon * kEpsilon * glm::dot(ray.direction, ray.direction)) return false;
    const auto [low, high] = std::minmax({o.y + within.lo * d.y, o.y + within.hi * d.y});
    const double bottom = low - slack, top = high + slack;
    // Signed distance from the ray's line, up to a factor.
    const auto side = [&](const dvec2& p) { return d.x * (p.y - o.y) - d.y * (p.x - o.x); };
    for (const OutlinePiece& e : glyph.pieces) {
      if ((e.p0.y < bottom && e.p2.y < bottom) || (e.p0.y > top && e.p2.y > top)) continue;
      const double s0 = side(e.p0);
      const double s1 = side(e.p1);
      const double s2 = side(e.p2);
      if ((s0 > 0 && s1 > 0 && s2 > 0) || (s0 < 0 && s1 < 0 && s2 < 0)) continue;
      double square = s0 - 2 * s1 + s2;
      if (std::abs(square) < 1e-14 * (std::abs(s0) + std::abs(s2))) square = 0;  // a line
      for (const double root : solve_quadratic({s0, 2 * (s1 - s0), square}, kPiece)) {
        const double w = std::clamp(root, 0.0, 1.0);
        const double t = glm::dot(e.at(w) - o, d) / glm::dot(d, d);
        const double z = ray.origin.z + t * ray.direction.z;
        if (z < 0 || z > depth_) continue;
        const dvec2 tangent = e.tangent(w);
        if (sink(t, 1, std::array<double, 3>{tangent.y, -tangent.x, 0}) && !depth_matters<Sink>()) return true;
      }
    }
    return false;
  }

  std::vector<GlyphOutline> glyphs_;
  double depth_;
  SharedTransform to_world_;
};

}  // namespace

std::unique_ptr<Shape> build(const Text& text, const SharedTransform& to_world, BuildContext&) {
  auto glyphs = lay_out_text(*text.font, text.string, dvec2(text.offset.x, text.offset.y), text.unicode_first);
  std::erase_if(glyphs, [](const GlyphOutline& glyph) { return glyph.pieces.empty(); });
  return std::make_unique<Lettering>(std::move(glyphs), text.depth, Transform::rotate(dvec3(0.001)).then(to_world));
}

}  // namespace lute
