#include "engine/shape/prism.hpp"

#include <algorithm>
#include <cmath>

#include "engine/math/polynomial.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

constexpr Interval kSegment{-1e-10, 1 + 1e-10};

bool same_point(const dvec2& a, const dvec2& b) { return std::abs(a.x - b.x) < kEpsilon && std::abs(a.y - b.y) < kEpsilon; }

PrismOutline linear_outline(const std::vector<dvec2>& p) {
  PrismOutline outline;
  for (std::size_t i = 0; i < p.size();) {
    const dvec2 start = p[i];
    std::size_t k = i + 1;
    for (; k < p.size(); ++k) {
      outline.segments.push_back(linear_segment(p[k - 1], p[k]));
      if (same_point(p[k], start)) break;
    }
    if (k == p.size()) {
      outline.closed = false;
      outline.segments.push_back(linear_segment(p[k - 1], start));
    }
    i = k + 1;
  }
  return outline;
}

// Quadratic and cubic sub-curves: a leading point, the start, and on until a segment ends at the start.
PrismOutline steered_outline(const std::vector<dvec2>& p, bool cubic) {
  PrismOutline outline;
  const std::size_t trailing = cubic ? 1 : 0;
  std::size_t i = 0;
  while (i + 1 < p.size()) {  // a single point that is left over steers nothing
    bool complete = false;
    for (std::size_t k = i; k + 2 + trailing < p.size() && !complete; ++k) {
      outline.segments.push_back(cubic ? cubic_segment(p[k], p[k + 1], p[k + 2], p[k + 3])
                                       : quadratic_segment(p[k], p[k + 1], p[k + 2]));
      complete = same_point(p[k + 2], p[i + 1]);
      if (complete) i = k + 3 + trailing;
    }
    if (!complete) return {{}, false};
  }
  return outline;
}

PrismOutline bezier_outline(const std::vector<dvec2>& p) {
  PrismOutline outline;
  dvec2 start = p.empty() ? dvec2(0) : p[0];
  for (std::size_t i = 0; i + 4 <= p.size(); i += 4) {
    if (i > 0 && !same_point(p[i], p[i - 1])) {
      if (!same_point(p[i - 1], start)) return {{}, false};
      start = p[i];
    }
    outline.segments.push_back(bezier_segment(p[i + 3], p[i + 2], p[i + 1], p[i]));  // runs backwards, as the reference's
  }
  if (p.size() < 4 || !same_point(p[p.size() / 4 * 4 - 1], start)) return {{}, false};
  return outline;
}

struct PrismSegment {
  PlanarSegment curve;
  Interval x, z;
  dvec2 from, to;
  std::array<dvec2, 4> controls;  // the segment lies in the hull of these: its Bézier points

  // The least and the largest k.x x + k.y z + k.z in the hull, a little widened.
  Interval range_of(const dvec3& k) const {
    Interval sides{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const dvec2& c : controls) {
      const double side = k.x * c.x + k.y * c.y + k.z;
      sides.lo = std::min(sides.lo, side);
      sides.hi = std::max(sides.hi, side);
    }
    const double slack = 1e-9 * (sides.hi - sides.lo);
    return {sides.lo - slack, sides.hi + slack};
  }
  // Whether all of the hull lies on one side of the line k.x x + k.y z + k.z = 0.
  bool is_beside(const dvec3& k) const { return !range_of(k).contains(0); }
  // Whether all of the hull lies before or behind a stretch of a ray, seen from above.
  bool is_apart(const Ray& ray, Interval depths) const {
    const double dx = ray.direction.x, dz = ray.direction.z, level = dx * dx + dz * dz;
    const Interval along = range_of({dx, dz, -(dx * ray.origin.x + dz * ray.origin.z)});
    return along.lo > depths.hi * level || along.hi < depths.lo * level;
  }
};

// A part of a segment over which neither coordinate turns.
struct MonotonePart {
  PlanarSegment curve;
  double begin, end;
  dvec2 from, to;

  // Whether a line of constant z, between those of the ends, crosses it at x or beyond.
  bool crosses_beyond(double x, double z) const {
    if (x <= std::min(from.x, to.x)) return true;
    if (x > std::max(from.x, to.x)) return false;
    const bool straight = curve.a == dvec2(0) && curve.b == dvec2(0);
    if (straight) return curve.at((z - curve.d.y) / curve.c.y).x >= x;
    // Halved until all that is left lies on one side of x: where on the curve is not asked.
    double near = begin, far = end, near_x = from.x, far_x = to.x;
    const bool above = from.y > z;
    for (;;) {
      const double middle = 0.5 * (near + far);
      if (!(near < middle && middle < far)) return far_x >= x;
      const dvec2 at = curve.at(middle);
      if ((at.y > z) == above) {
        near = middle;
        near_x = at.x;
      } else {
        far = middle;
        far_x = at.x;
      }
      if (x <= std::min(near_x, far_x)) return true;
      if (x > std::max(near_x, far_x)) return false;
    }
  }
};

// The Bézier points of a cubic over [0, 1], from its coefficients.
std::array<double, 4> bezier_points(const std::array<double, 4>& c) {
  const double first = c[0] + c[1] / 3, second = first + (c[1] + c[2]) / 3;
  return {c[0], first, second, c[0] + c[1] + c[2] + c[3]};
}

// The rectangle of x and z in which a ray may meet sides.
struct Section {
  Interval x, z;
  bool meets(const PrismSegment& s) const { return s.x.lo <= x.hi && s.x.hi >= x.lo && s.z.lo <= z.hi && s.z.hi >= z.lo; }
};

enum Part : std::uint32_t { kCaps, kFirstSegment };

// A hit on a side keeps the segment in its part and the curve's parameter.
class SweptOutline final : public ScannedShape<SweptOutline> {
 public:
  SweptOutline(const Prism& prism, const SharedTransform& to_world)
      : conic_(prism.conic),
        open_(prism.open),
        low_(std::min(prism.height_1, prism.height_2)),
        high_(std::max(prism.height_1, prism.height_2)),
        to_world_(to_world) {
    degree_ = prism.spline == PlanarSpline::kLinear ? 1 : prism.spline == PlanarSpline::kQuadratic ? 2 : 3;
    x_ = z_ = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const PlanarSegment& curve : prism_outline(prism).segments) {
      segments_.push_back({curve, curve.range(0), curve.range(1), curve.at(0), curve.at(1), {}});
      const std::array<double, 4> control_x = bezier_points(curve.coefficients(0)), control_z = bezier_points(curve.coefficients(1));
      for (std::size_t i = 0; i < 4; ++i) segments_.back().controls[i] = {control_x[i], control_z[i]};
      x_ = {std::min(x_.lo, segments_.back().x.lo), std::max(x_.hi, segments_.back().x.hi)};
      z_ = {std::min(z_.lo, segments_.back().z.lo), std::max(z_.hi, segments_.back().z.hi)};
    }
    join_corners(prism.spline == PlanarSpline::kBezier);
    for (const PrismSegment& segment : segments_) add_parts(segment);
    box_ = local_box();
    const dvec3 slack = 1e-9 * (box_.hi - box_.lo);
    box_ = {box_.lo - slack, box_.hi + slack};
  }

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    Ray local = to_world_->inverse_ray(ray);
    const double length = glm::length(local.direction);
    local.direction /= length;
    const double dy = local.direction.y;
    if (std::abs(dy) < kEpsilon && (local.origin.y < low_ || local.origin.y > high_)) return;
    // Depths that still count, a little widened; in local units.
    Interval wanted{range.lo * length - 1e-9 * std::abs(range.lo * length), range.hi * length * (1 + 1e-9)};
    if (!meets_box(local, wanted)) return;
    bool enough = false;
    const auto found = [&](double t, std::uint32_t part, double w) {
      if (!sink(t / length, part, std::array<double, 3>{w, 0, 0})) return;
      wanted.hi = std::min(wanted.hi, t + 1e-9 * std::abs(t));
      enough = !depth_matters<Sink>();
    };
    if (!open_ && std::abs(dy) >= kEpsilon) {
      for (const double height : {high_, low_}) {
        const double t = (height - local.origin.y) / dy;
        const dvec3 p = local.at(t);
        if (wanted.contains(t) && in_section(p.x, p.z, height)) found(t, kCaps, 0);
        if (enough) return;
      }
    }
    const Section passage = section_between(local, low_, high_);
    if (!conic_ && std::abs(dy) >= kEpsilon) {
      const double a = (low_ - local.origin.y) / dy, b = (high_ - local.origin.y) / dy, slack = 1e-9 * (std::abs(a) + std::abs(b));
      wanted = {std::max(wanted.lo, std::min(a, b) - slack), std::min(wanted.hi, std::max(a, b) + slack)};
    }
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (!passage.meets(segments_[i])) continue;
      const auto emit = [&](double t, double w) {
        const double y = local.origin.y + t * dy;
        if (y >= low_ && y <= high_) found(t, kFirstSegment + static_cast<std::uint32_t>(i), w);
      };
      if (conic_) {
        scan_conic_side(segments_[i], local, emit);
      } else if (degree_ == 1 || !segments_[i].is_apart(local, wanted)) {
        scan_side(segments_[i], local, emit);
      }
      if (enough) return;
    }
  }

  Aabb bounds() const override {
    return segments_.empty() ? Aabb{} : to_world_->box(local_box());
  }
  bool inside(const dvec3& point) const override {
    const dvec3 p = to_world_->inverse_point(point);
    return p.y >= low_ && p.y < high_ && in_section(p.x, p.z, p.y);
  }
  dvec3 normal(const ShapeHit& hit, const dvec3& point) const override {
    if (hit.part == kCaps) return glm::normalize(to_world_->normal({0, 1, 0}));
    const dvec2 tangent = segments_[hit.part - kFirstSegment].curve.tangent(hit.data[0]);
    dvec3 n(tangent.y, 0, -tangent.x);
    if (conic_) {
      const dvec3 p = to_world_->inverse_point(point);
      if (std::abs(p.y) > kEpsilon) {
        n.y = -(p.x * tangent.y - p.z * tangent.x) / p.y;
      } else {
        n = {0, 1, 0};
      }
    }
    return glm::normalize(to_world_->normal(n));
  }

 private:
  Aabb local_box() const {
    Aabb box;
    for (const double height : {low_, high_}) {
      const double k = conic_ ? height : 1;
      box.join(dvec3(k * x_.lo, height, k * z_.lo));
      box.join(dvec3(k * x_.hi, height, k * z_.hi));
    }
    return box;
  }

  // Whether a stretch of the ray meets the box of the outline, which may lie in the world as it likes.
  bool meets_box(const Ray& ray, Interval depths) const {
    double near = -std::numeric_limits<double>::infinity(), far = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const double low = box_.lo[axis] - ray.origin[axis], high = box_.hi[axis] - ray.origin[axis];
      const double d = ray.direction[axis];
      if (d == 0) {
        if (low > 0 || high < 0) return false;
        continue;
      }
      const double a = low / d, b = high / d;
      near = std::max(near, std::min(a, b));
      far = std::min(far, std::max(a, b));
    }
    // Rounding of the depths, which far from the box is more than its slack.
    const double slack = 1e-9 * std::max(std::abs(near), std::abs(far));
    return near <= far + slack && near <= depths.hi + slack && far >= depths.lo - slack;
  }

  // Where the ray is between two heights, a little widened; of a cone or a level ray everywhere.
  Section section_between(const Ray& ray, double low, double high) const {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    if (conic_ || std::abs(ray.direction.y) < kEpsilon) return {{-kFar, kFar}, {-kFar, kFar}};
    const dvec3 a = ray.at((low - ray.origin.y) / ray.direction.y), b = ray.at((high - ray.origin.y) / ray.direction.y);
    const auto around = [](double p, double q, const Interval& all) {
      const double slack = 1e-9 * (all.hi - all.lo + std::abs(p) + std::abs(q));
      return Interval{std::min(p, q) - slack, std::max(p, q) + slack};
    };
    return {around(a.x, b.x, x_), around(a.z, b.z, z_)};
  }

  // Gives segments that meet the same corner, to the last bit. Those of Bézier splines follow each other backwards.
  void join_corners(bool backwards) {
    const std::size_t count = segments_.size();
    const auto at = [&](std::size_t i) -> PrismSegment& { return segments_[backwards ? count - 1 - i : i]; };
    for (std::size_t i = 0, start = 0; i < count; ++i) {
      const bool last = i + 1 == count || same_point(at(i).to, at(start).from);
      at(i).to = at(last ? start : i + 1).from;
      if (last) start = i + 1;
    }
  }

  bool in_section(double x, double z, double height) const {
    if (!conic_) return in_outline(x, z);
    return std::abs(height) > kEpsilon && in_outline(x / height, z / height);
  }

  void add_parts(const PrismSegment& segment) {
    std::vector<double> borders{0, 1};
    if (degree_ > 1)
      for (int axis = 0; axis < 2; ++axis) {
        const std::array<double, 4> c = segment.curve.coefficients(axis);
        for (const double turn : solve_quadratic({c[1], 2 * c[2], 3 * c[3]}, {0, 1})) borders.push_back(turn);
      }
    std::sort(borders.begin(), borders.end());
    dvec2 from = segment.from;
    for (std::size_t i = 1; i < borders.size(); ++i) {
      const dvec2 to = i + 1 == borders.size() ? segment.to : segment.curve.at(borders[i]);
      parts_.push_back({segment.curve, borders[i - 1], borders[i], from, to});
      from = to;
    }
  }

  // Even-odd rule. A crossing is counted where a monotone part of the outline passes from above z to not above it, so that an
  // outline which only touches the line z, or has a corner on it, is counted right.
  bool in_outline(double x, double z) const {
    if (!x_.contains(x) || !z_.contains(z)) return false;
    bool odd = false;
    for (const MonotonePart& part : parts_)
      if ((part.from.y > z) != (part.to.y > z)) odd ^= part.crosses_beyond(x, z);
    return odd;
  }

  template <class Emit>
  void scan_side(const PrismSegment& segment, const Ray& ray, Emit&& emit) const {
    const dvec3& p = ray.origin;
    const dvec3& d = ray.direction;
    if (std::abs(d.x) <= kEpsilon && std::abs(d.z) <= kEpsilon) return;
    if (degree_ == 1) return scan_straight_side(segment, ray, emit);
    if (segment.is_beside({d.z, -d.x, d.x * p.z - d.z * p.x})) return;
    const std::array<double, 4> x = segment.curve.coefficients(0);
    const std::array<double, 4> z = segment.curve.coefficients(1);
    std::array<double, 4> c;
    for (std::size_t i = 0; i < 4; ++i) c[i] = d.z * x[i] - d.x * z[i];
    c[0] -= d.z * p.x - d.x * p.z;
    for (const double root : roots_of(c)) {
      const double w = std::clamp(root, 0.0, 1.0);
      const dvec2 at = segment.curve.at(w);
      emit(std::abs(d.x) > std::abs(d.z) ? (at.x - p.x) / d.x : (at.y - p.z) / d.z, w);
    }
  }

  // A straight segment is hit where its ends lie on different sides of the ray's line; what lies on the line counts with one of
  // them. Segments that meet compute the same number for the corner they share, so that a ray through it hits exactly one of them,
  // or none or both where the outline only touches the line, and of two prisms side by side exactly one.
  template <class Emit>
  void scan_straight_side(const PrismSegment& segment, const Ray& ray, Emit&& emit) const {
    const dvec3& p = ray.origin;
    const dvec3& d = ray.direction;
    const auto side = [&](const dvec2& at) { return d.z * (at.x - p.x) - d.x * (at.y - p.z); };
    const double from = side(segment.from), to = side(segment.to);
    if ((from >= 0) == (to >= 0)) return;
    const double w = from / (from - to);
    const dvec2 at = segment.from + w * (segment.to - segment.from);
    emit(std::abs(d.x) > std::abs(d.z) ? (at.x - p.x) / d.x : (at.y - p.z) / d.z, w);
  }

  template <class Emit>
  void scan_conic_side(const PrismSegment& segment, const Ray& ray, Emit&& emit) const {
    const dvec3& p = ray.origin;
    const dvec3& d = ray.direction;
    const double k1 = p.z * d.y - p.y * d.z;
    const double k2 = p.y * d.x - p.x * d.y;
    const double k3 = p.x * d.z - p.z * d.x;
    if (segment.is_beside({k1, k2, k3})) return;
    const std::array<double, 4> x = segment.curve.coefficients(0);
    const std::array<double, 4> z = segment.curve.coefficients(1);
    std::array<double, 4> c;
    for (std::size_t i = 0; i < 4; ++i) c[i] = k1 * x[i] + k2 * z[i];
    c[0] += k3;
    for (const double root : roots_of(c)) {
      const double w = std::clamp(root, 0.0, 1.0);
      const dvec2 at = segment.curve.at(w);
      const double by_x = d.x - at.x * d.y;
      const double by_z = d.z - at.y * d.y;
      if (std::max(std::abs(by_x), std::abs(by_z)) <= kEpsilon) continue;
      emit(std::abs(by_x) > std::abs(by_z) ? (at.x * p.y - p.x) / by_x : (at.y * p.y - p.z) / by_z, w);
    }
  }

  Roots<3> roots_of(const std::array<double, 4>& c) const { return solve_cubic(c, kSegment); }

  std::vector<PrismSegment> segments_;
  std::vector<MonotonePart> parts_;  // of all of them
  int degree_ = 1;
  bool conic_, open_;
  double low_, high_;
  Interval x_, z_;
  Aabb box_;  // in local units, a little widened
  SharedTransform to_world_;
};

}  // namespace

PrismOutline prism_outline(const Prism& prism) {
  switch (prism.spline) {
    case PlanarSpline::kLinear: return linear_outline(prism.points);
    case PlanarSpline::kQuadratic: return steered_outline(prism.points, false);
    case PlanarSpline::kCubic: return steered_outline(prism.points, true);
    case PlanarSpline::kBezier: break;
  }
  return bezier_outline(prism.points);
}

std::unique_ptr<Shape> build(const Prism& prism, const SharedTransform& to_world, BuildContext&) {
  return std::make_unique<SweptOutline>(prism, to_world);
}

}  // namespace lute
