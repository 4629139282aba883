#include "engine/shape/lathe.hpp"

#include <algorithm>
#include <cmath>

#include "engine/math/polynomial.hpp"
#include "engine/math/root_walk.hpp"
#include "engine/shape/revolution_shell.hpp"
#include "engine/shape/scanned_shape.hpp"
#include "engine/shape/unit_sphere_uv.hpp"

namespace lute {

namespace {

// Joints of segments are met from both sides, so that no ray slips through between them.
constexpr Interval kSegment{-1e-10, 1 + 1e-10};
constexpr double kHorizontal = 1e-8;  // slope below which the height of a ray does not change

struct LatheSegment {
  PlanarSegment curve;
  RevolutionShell shell;
};

std::vector<PlanarSegment> profile(const Lathe& lathe) {
  const std::vector<dvec2>& p = lathe.points;
  std::vector<PlanarSegment> segments;
  for (std::size_t i = 0; i + least_points(lathe.spline) <= p.size();) {
    switch (lathe.spline) {
      case PlanarSpline::kLinear: segments.push_back(linear_segment(p[i], p[i + 1])); break;
      case PlanarSpline::kQuadratic: segments.push_back(quadratic_segment(p[i], p[i + 1], p[i + 2])); break;
      case PlanarSpline::kCubic: segments.push_back(cubic_segment(p[i], p[i + 1], p[i + 2], p[i + 3])); break;
      case PlanarSpline::kBezier: segments.push_back(bezier_segment(p[i], p[i + 1], p[i + 2], p[i + 3])); break;
    }
    i += lathe.spline == PlanarSpline::kBezier ? 4 : 1;
  }
  return segments;
}

// A hit keeps the segment as its part and the curve's parameter.
class TurnedProfile final : public ScannedShape<TurnedProfile> {
 public:
  TurnedProfile(const Lathe& lathe, const SharedTransform& to_world) : to_world_(to_world) {
    degree_ = lathe.spline == PlanarSpline::kLinear ? 1 : lathe.spline == PlanarSpline::kQuadratic ? 2 : 3;
    heights_ = radii_ = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const PlanarSegment& curve : profile(lathe)) {
      const Interval x = curve.range(0);
      const Interval radii{x.lo < 0 && x.hi > 0 ? 0 : std::min(std::abs(x.lo), std::abs(x.hi)),
                           std::max(std::abs(x.lo), std::abs(x.hi))};
      const Interval heights = curve.range(1);
      segments_.push_back({curve, {heights, radii}});
      heights_ = {std::min(heights_.lo, heights.lo), std::max(heights_.hi, heights.hi)};
      radii_ = {std::min(radii_.lo, radii.lo), std::max(radii_.hi, radii.hi)};
    }
  }

  template <class Sink>
  void scan(const Ray& ray, Interval, Sink&& sink) const {
    Ray local = to_world_->inverse_ray(ray);
    const double length = glm::length(local.direction);
    local.direction /= length;
    const double shift = glm::dot(dvec3(0, 0.5 * (heights_.lo + heights_.hi), 0) - local.origin, local.direction);
    local.origin += shift * local.direction;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (!segments_[i].shell.meets(local)) continue;
      const auto emit = [&](double t, double w) {
        sink((t + shift) / length, static_cast<std::uint32_t>(i), std::array<double, 3>{w, 0, 0});
      };
      if (std::abs(local.direction.y) > kHorizontal) {
        scan_slanted(segments_[i].curve, local, emit);
      } else {
        scan_level(segments_[i].curve, local, emit);
      }
    }
  }

  Aabb bounds() const override {
    if (segments_.empty()) return {};
    return to_world_->box({{-radii_.hi, heights_.lo, -radii_.hi}, {radii_.hi, heights_.hi, radii_.hi}});
  }
  bool inside(const dvec3& point) const override {
    const dvec3 p = to_world_->inverse_point(point);
    const double rho = std::hypot(p.x, p.z);
    if (!heights_.contains(p.y) || !radii_.contains(rho)) return false;
    bool odd = false;
    for (const LatheSegment& segment : segments_) {
      const Interval& heights = segment.shell.heights;
      if (p.y < heights.lo - kEpsilon || p.y > heights.hi + kEpsilon) continue;
      std::array<double, 4> c = segment.curve.coefficients(1);
      c[0] -= p.y;
      for (const double w : solve_cubic(c, {0, 1})) odd ^= segment.curve.at(w).x >= rho;
    }
    return odd;
  }
  dvec3 normal(const ShapeHit& hit, const dvec3& point) const override {
    const dvec3 p = to_world_->inverse_point(point);
    const double rho2 = p.x * p.x + p.z * p.z;
    const dvec2 tangent = segments_[hit.part].curve.tangent(hit.data[0]);
    const dvec3 n = rho2 > kEpsilon ? dvec3(tangent.y * p.x, -tangent.x * std::sqrt(rho2), tangent.y * p.z) : dvec3(0, 1, 0);
    return glm::normalize(to_world_->normal(n));
  }
  dvec2 uv(const ShapeHit& hit, const dvec3& point) const override {
    const dvec3 p = to_world_->inverse_point(point);
    return {longitude_share(p.x, p.z), std::min(1.0, (hit.data[0] + hit.part) / static_cast<double>(segments_.size()))};
  }

 private:
  // a Y² + 2 b dy Y + dy² (|P|² - X²) = 0 in the curve's parameter, with Y measured from the ray's origin.
  template <class Emit>
  void scan_slanted(const PlanarSegment& curve, const Ray& ray, Emit&& emit) const {
    const dvec3& p = ray.origin;
    const dvec3& d = ray.direction;
    const double a = d.x * d.x + d.z * d.z;
    const double b = p.x * d.x + p.z * d.z;
    const double c = p.x * p.x + p.z * p.z;
    const std::array<double, 4> x = curve.coefficients(0);
    std::array<double, 4> y = curve.coefficients(1);
    y[0] -= p.y;
    std::array<double, 7> e{};
    for (std::size_t i = 0; i <= degree_; ++i)
      for (std::size_t j = 0; j <= degree_; ++j) e[i + j] += a * y[i] * y[j] - d.y * d.y * x[i] * x[j];
    for (std::size_t i = 0; i <= degree_; ++i) e[i] += 2 * b * d.y * y[i];
    e[0] += d.y * d.y * c;
    const auto at_parameter = [&](double root) {
      const double w = std::clamp(root, 0.0, 1.0);
      emit_depths(curve.at(w) - dvec2(0, p.y), d.y, a, b, c, [&](double t) { emit(t, w); });
      return false;
    };
    if (degree_ == 1) {
      walk_roots(std::array{e[0], e[1], e[2]}, kSegment, at_parameter);
    } else if (degree_ == 2) {
      walk_roots(std::array{e[0], e[1], e[2], e[3], e[4]}, kSegment, at_parameter);
    } else {
      walk_roots(e, kSegment, at_parameter);
    }
  }

  // Depths of the point (X, Y) of the profile: by its height, or for flat rays by its radius, which is better conditioned then. The
  // flattest rays meet both sides at parameters that rounding cannot tell apart: one root stands for both.
  template <class Emit>
  void emit_depths(const dvec2& at, double dy, double a, double b, double c, Emit&& emit) const {
    const double by_height = at.y / dy;
    const double discriminant = b * b - a * (c - at.x * at.x);
    if (std::abs(dy) > 1e-3 || !(discriminant > 0)) return emit(by_height);
    const double near = (-b - std::sqrt(discriminant)) / a;
    const double far = (-b + std::sqrt(discriminant)) / a;
    const bool nearer = std::abs(near - by_height) < std::abs(far - by_height);
    emit(nearer ? near : far);
    const double other = nearer ? far : near;
    if (std::abs(other * dy - at.y) < 5e-7 * radii_.hi) emit(other);
  }

  template <class Emit>
  void scan_level(const PlanarSegment& curve, const Ray& ray, Emit&& emit) const {
    const dvec3& p = ray.origin;
    const dvec3& d = ray.direction;
    std::array<double, 4> y = curve.coefficients(1);
    y[0] -= p.y;
    for (const double root : solve_cubic(y, kSegment)) {
      const double w = std::clamp(root, 0.0, 1.0);
      const double x = curve.at(w).x;
      constexpr double kInfinity = std::numeric_limits<double>::infinity();
      for (const double t : solve_quadratic({p.x * p.x + p.z * p.z - x * x, 2 * (p.x * d.x + p.z * d.z), d.x * d.x + d.z * d.z},
                                            {-kInfinity, kInfinity}))
        emit(t, w);
    }
  }

  std::vector<LatheSegment> segments_;
  std::size_t degree_ = 1;
  Interval heights_, radii_;
  SharedTransform to_world_;
};

}  // namespace

std::unique_ptr<Shape> build(const Lathe& lathe, const SharedTransform& to_world, BuildContext&) {
  return std::make_unique<TurnedProfile>(lathe, to_world);
}

}  // namespace lute
