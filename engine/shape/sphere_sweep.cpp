#include "engine/shape/sphere_sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/math/certified_roots.hpp"
#include "engine/math/polynomial.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

constexpr double kMaxDepth = 1e7;
constexpr Interval kSegment{0, 1};

// Products of polynomials, ascending. The sizes are small and fixed: the compiler unrolls them.
template <std::size_t A, std::size_t B>
std::array<double, A + B - 1> product(const std::array<double, A>& a, const std::array<double, B>& b) {
  std::array<double, A + B - 1> c{};
  for (std::size_t i = 0; i < A; ++i)
    for (std::size_t j = 0; j < B; ++j) c[i + j] += a[i] * b[j];
  return c;
}

template <std::size_t N>
std::array<double, N - 1> derivative(const std::array<double, N>& a) {
  std::array<double, N - 1> c;
  for (std::size_t i = 0; i + 1 < N; ++i) c[i] = static_cast<double>(i + 1) * a[i + 1];
  return c;
}

// The sphere at one end of a segment, and how fast it moves and grows there.
struct SweepEnd {
  dvec3 center, slope;
  double radius, radius_slope;
};

// Centre and radius as cubics of u in [0, 1].
struct SweepSegment {
  std::array<dvec3, 4> center;
  std::array<double, 4> radius;

  std::array<double, 7> power{};  // |c(u) - c(0)|² - r(u)²
  SweepEnd first{}, last{};

  dvec3 center_at(double u) const { return ((center[3] * u + center[2]) * u + center[1]) * u + center[0]; }
  double radius_at(double u) const { return ((radius[3] * u + radius[2]) * u + radius[1]) * u + radius[0]; }
  SweepEnd end(double u) const {
    return {center_at(u), (3.0 * center[3] * u + 2.0 * center[2]) * u + center[1], radius_at(u), (3 * radius[3] * u + 2 * radius[2]) * u + radius[1]};
  }
};

// The basis of chapter 20 §5.14, for a value of any kind.
template <class Value>
std::array<Value, 4> interpolate(SphereSweep::Spline spline, const Value& p0, const Value& p1, const Value& p2, const Value& p3) {
  switch (spline) {
    case SphereSweep::Spline::kLinear: return {p1, p2 - p1, Value(0), Value(0)};
    case SphereSweep::Spline::kCubic:
      return {p1, 0.5 * (p2 - p0), 0.5 * (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3), 0.5 * (3.0 * (p1 - p2) + p3 - p0)};
    case SphereSweep::Spline::kBSpline: break;
  }
  return {(p0 + 4.0 * p1 + p2) / 6.0, 0.5 * (p2 - p0), 0.5 * (p0 - 2.0 * p1 + p2), (3.0 * (p1 - p2) + p3 - p0) / 6.0};
}

SweepSegment sweep_segment(const std::array<dvec3, 4>& center, const std::array<double, 4>& radius) {
  SweepSegment s{center, radius};
  s.first = s.end(0);
  s.last = s.end(1);
  for (int axis = 0; axis < 3; ++axis) {
    const std::array<double, 4> w{0, center[1][axis], center[2][axis], center[3][axis]};
    const std::array<double, 7> square = product(w, w);
    for (std::size_t i = 0; i < 7; ++i) s.power[i] += square[i];
  }
  const std::array<double, 7> square = product(radius, radius);
  for (std::size_t i = 0; i < 7; ++i) s.power[i] -= square[i];
  return s;
}

// |q - c(u)|² - r(u)² as a polynomial of u. In coordinates about c(0), so that far from the origin nothing is lost.
std::array<double, 7> sphere_power(const SweepSegment& s, const dvec3& q) {
  const dvec3 from_start = q - s.center[0];
  std::array<double, 7> power = s.power;
  power[0] += glm::dot(from_start, from_start);
  for (std::size_t i = 1; i < 4; ++i) power[i] -= 2 * glm::dot(from_start, s.center[i]);
  return power;
}

struct Candidate {
  double t;
  dvec3 normal;
};
using Candidates = std::vector<Candidate>;

void add_sphere(const Ray& ray, const dvec3& center, double radius, Candidates& out) {
  const dvec3 w = center - ray.origin;
  const double q = glm::dot(w, w);
  const double b = glm::dot(w, ray.direction);
  if (q >= radius * radius && b < kEpsilon) return;
  const dvec3 apart = w - b * ray.direction;
  const double h = radius * radius - glm::dot(apart, apart);
  if (!(h > kEpsilon * radius * radius)) return;
  for (const double t : {b - std::sqrt(h), b + std::sqrt(h)})
    if (std::abs(t) < kMaxDepth) out.push_back({t, (ray.at(t) - center) / radius});
}

// The plane through the circle in which the envelope touches the sphere at one end of a segment.
void add_closing_plane(const Ray& ray, const SweepEnd& end, double outwards, Candidates& out) {
  const double speed = glm::dot(ray.direction, end.slope);
  if (std::abs(speed) <= kEpsilon) return;
  const double t = -(glm::dot(ray.origin - end.center, end.slope) + end.radius * end.radius_slope) / speed;
  const dvec3 from_center = ray.at(t) - end.center;
  if (std::abs(t) >= kMaxDepth || !(glm::dot(from_center, from_center) < end.radius * end.radius)) return;
  out.push_back({t, outwards * glm::normalize(end.slope)});
}

// A hit keeps its normal.
class Sweep final : public ScannedShape<Sweep> {
 public:
  Sweep(const SphereSweep& sweep, const SharedTransform& to_world)
      : spline_(sweep.spline), tolerance_(sweep.tolerance), to_world_(to_world) {
    const auto& p = sweep.balls;
    const bool linear = spline_ == SphereSweep::Spline::kLinear;
    const std::size_t segments = linear ? p.size() - 1 : p.size() - 3;
    for (std::size_t i = 0; i < segments; ++i) {
      const auto& a = linear ? p[i] : p[i + 1];
      const auto& b = linear ? p[i + 1] : p[i + 2];
      const auto& before = linear ? a : p[i];
      const auto& after = linear ? b : p[i + 3];
      segments_.push_back(sweep_segment(interpolate(spline_, before.center, a.center, b.center, after.center),
                           interpolate(spline_, before.radius, a.radius, b.radius, after.radius)));
      boxes_.push_back(segment_box(segments_.back()));
    }
  }

  template <class Sink>
  void scan(const Ray& ray, Interval, Sink&& sink) const {
    Ray local = to_world_->inverse_ray(ray);
    const double length = glm::length(local.direction);
    local.direction /= length;
    thread_local Candidates candidates;
    candidates.clear();
    collect(local, candidates);
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) { return a.t < b.t; });
    int depth = 1;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const Candidate& c = candidates[i];
      bool keep = true;
      if (i != 0 && i + 1 != candidates.size()) {
        const bool enters = glm::dot(c.normal, local.direction) < 0;
        keep = depth == (enters ? 0 : 1);
        depth += enters ? 1 : -1;
      }
      if (keep && c.t / length > tolerance_)
        sink(c.t / length, 0, std::array<double, 3>{c.normal.x, c.normal.y, c.normal.z});
    }
  }

  Aabb bounds() const override {
    Aabb box;
    for (const Aabb& part : boxes_) box.join(part);
    return to_world_->box(box);
  }
  bool inside(const dvec3& point) const override {
    const dvec3 p = to_world_->inverse_point(point);
    return std::ranges::any_of(segments_, [&](const SweepSegment& s) {
      const std::array<double, 7> power = sphere_power(s, p);
      if (spline_ == SphereSweep::Spline::kLinear)
        return solve_quadratic({power[0], power[1], power[2]}, kSegment).count > 0;
      return may_have_root(power, kSegment) && solve_polynomial(power, kSegment).count > 0;
    });
  }
  dvec3 normal(const ShapeHit& hit, const dvec3&) const override {
    return glm::normalize(to_world_->normal({hit.data[0], hit.data[1], hit.data[2]}));
  }

 private:
  // Around all spheres of a segment.
  static Aabb segment_box(const SweepSegment& s) {
    Aabb box;
    for (int axis = 0; axis < 3; ++axis) {
      std::array<double, 4> low, high;
      for (std::size_t i = 0; i < 4; ++i) {
        low[i] = s.center[i][axis] - s.radius[i];
        high[i] = s.center[i][axis] + s.radius[i];
      }
      const Interval l = cubic_value_range(low, kSegment);
      const Interval h = cubic_value_range(high, kSegment);
      box.lo[axis] = std::min(l.lo, h.lo);
      box.hi[axis] = std::max(l.hi, h.hi);
    }
    return box;
  }

  // Whether the line of the ray, also behind its origin, passes a box; a little generously.
  static bool line_meets(const Ray& ray, const dvec3& reciprocal, const Aabb& box) {
    Interval depths{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    const dvec3 slack = 1e-9 * (box.hi - box.lo);
    for (int axis = 0; axis < 3; ++axis) {
      const double low = box.lo[axis] - slack[axis] - ray.origin[axis], high = box.hi[axis] + slack[axis] - ray.origin[axis];
      if (ray.direction[axis] == 0) {
        if (low > 0 || high < 0) return false;
        continue;
      }
      const double a = low * reciprocal[axis], b = high * reciprocal[axis];
      depths = {std::max(depths.lo, std::min(a, b)), std::min(depths.hi, std::max(a, b))};
    }
    return depths.lo <= depths.hi;
  }

  // What a segment adds lies in its box, so that segments beside the ray are left out.
  void collect(const Ray& ray, Candidates& out) const {
    thread_local std::vector<const SweepSegment*> met;
    met.clear();
    const dvec3 reciprocal = 1.0 / ray.direction;
    for (std::size_t i = 0; i < segments_.size(); ++i)
      if (line_meets(ray, reciprocal, boxes_[i])) met.push_back(&segments_[i]);
    if (met.empty()) return;
    for (const SweepSegment* s : met) add_sphere(ray, s->first.center, s->first.radius, out);
    // The sphere where a segment ends is that where the next one begins; if that one is beside the ray, so is the sphere.
    if (met.back() == &segments_.back()) add_sphere(ray, met.back()->last.center, met.back()->last.radius, out);
    for (const SweepSegment* s : met) {
      add_closing_plane(ray, s->first, -1, out);
      add_closing_plane(ray, s->last, 1, out);
    }
    for (const SweepSegment* segment : met) {
      const SweepSegment& s = *segment;
      // The polynomials are set up about the ray's point nearest to the segment.
      const double shift = glm::dot(s.center_at(0.5) - ray.origin, ray.direction);
      const Ray near{ray.at(shift), ray.direction};
      const std::size_t first = out.size();
      if (spline_ == SphereSweep::Spline::kLinear) {
        add_linear_side(near, s, out);
      } else {
        add_curved_side(near, s, out);
      }
      for (std::size_t i = first; i < out.size(); ++i) out[i].t += shift;
    }
  }

  // With t² + B t + C = |O + tD - c(u)|² - r(u)², the envelope's parameters solve C'² - B B' C' + B'² C = 0.
  static void add_linear_side(const Ray& ray, const SweepSegment& s, Candidates& out) {
    const std::array<double, 7> power = sphere_power(s, ray.origin);
    const std::array<double, 3> c{power[0], power[1], power[2]};
    const std::array<double, 2> b{2 * glm::dot(ray.direction, ray.origin - s.center[0]), -2 * glm::dot(ray.direction, s.center[1])};
    const std::array<double, 2> dc = derivative(c);
    const double db = b[1];
    const std::array<double, 3> dc2 = product(dc, dc);
    const std::array<double, 3> b_dc = product(b, dc);
    std::array<double, 3> e;
    for (std::size_t i = 0; i < 3; ++i) e[i] = dc2[i] - db * b_dc[i] + db * db * c[i];
    for (const double u : solve_quadratic(e, kSegment)) {
      const dvec3 center = s.center_at(u);
      if (std::abs(db) > 1e-4) {
        const double t = -(dc[0] + dc[1] * u) / db;
        out.push_back({t, glm::normalize(ray.at(t) - center)});
      } else {
        add_whole_sphere(ray, center, s.radius_at(u), out);
      }
    }
  }

  static void add_curved_side(const Ray& ray, const SweepSegment& s, Candidates& out) {
    const std::array<double, 7> c = sphere_power(s, ray.origin);
    std::array<double, 4> b;
    for (std::size_t i = 0; i < 4; ++i)
      b[i] = 2 * glm::dot(ray.direction, (i == 0 ? ray.origin : dvec3(0)) - s.center[i]);
    const std::array<double, 6> dc = derivative(c);
    const std::array<double, 3> db = derivative(b);
    std::array<double, 9> inner = product(db, c);
    const std::array<double, 9> b_dc = product(b, dc);
    for (std::size_t i = 0; i < inner.size(); ++i) inner[i] -= b_dc[i];
    std::array<double, 11> e = product(dc, dc);
    const std::array<double, 11> rest = product(db, inner);
    for (std::size_t i = 0; i < e.size(); ++i) e[i] += rest[i];
    for (const double u : certified_roots(e, kSegment)) add_whole_sphere(ray, s.center_at(u), s.radius_at(u), out);
  }

  // Both hits, wherever the origin is: the ray has been moved.
  static void add_whole_sphere(const Ray& ray, const dvec3& center, double radius, Candidates& out) {
    const dvec3 w = center - ray.origin;
    const double b = glm::dot(w, ray.direction);
    const dvec3 apart = w - b * ray.direction;
    const double h = radius * radius - glm::dot(apart, apart);
    if (!(h > kEpsilon * radius * radius)) return;
    for (const double t : {b - std::sqrt(h), b + std::sqrt(h)}) out.push_back({t, (ray.at(t) - center) / radius});
  }

  SphereSweep::Spline spline_;
  std::vector<SweepSegment> segments_;
  std::vector<Aabb> boxes_;  // of the segments
  double tolerance_;
  SharedTransform to_world_;
};

}  // namespace

std::unique_ptr<Shape> build(const SphereSweep& sweep, const SharedTransform& to_world, BuildContext&) {
  return std::make_unique<Sweep>(sweep, to_world);
}

}  // namespace lute
