#include "engine/shape/sor.hpp"

#include <algorithm>
#include <cmath>

#include "engine/math/polynomial.hpp"
#include "engine/shape/revolution_shell.hpp"
#include "engine/shape/scanned_shape.hpp"
#include "engine/shape/unit_sphere_uv.hpp"

namespace lute {

namespace {

struct SorSegment {
  std::array<double, 4> radius2;  // of the height above heights.lo, ascending
  RevolutionShell shell;

  double at(double height) const {
    return ((radius2[3] * height + radius2[2]) * height + radius2[1]) * height + radius2[0];
  }
};

// Between p1 and p2. Hermite's cubic of the squared radius, with slopes 2 r dr/dy from the neighbours.
SorSegment sor_segment(const dvec2& p0, const dvec2& p1, const dvec2& p2, const dvec2& p3) {
  const double h = p2.y - p1.y;
  const double f1 = p1.x * p1.x;
  const double f2 = p2.x * p2.x;
  const double slope1 = 2 * p1.x * (p2.x - p0.x) / (p2.y - p0.y);
  const double slope2 = 2 * p2.x * (p3.x - p1.x) / (p3.y - p1.y);
  const double secant = (f2 - f1) / h;
  SorSegment segment;
  segment.radius2 = {f1, slope1, (3 * secant - 2 * slope1 - slope2) / h, (slope1 + slope2 - 2 * secant) / (h * h)};
  const Interval squares = cubic_value_range(segment.radius2, {0, h});
  segment.shell = {{p1.y, p2.y}, {std::sqrt(std::max(0.0, squares.lo)), std::sqrt(std::max(0.0, squares.hi))}};
  return segment;
}

// Parts: the segments, then base and cap.
class TurnedSurface final : public ScannedShape<TurnedSurface> {
 public:
  TurnedSurface(const Sor& sor, const SharedTransform& to_world) : open_(sor.open), to_world_(to_world) {
    const std::vector<dvec2>& p = sor.points;
    for (std::size_t i = 0; i + 4 <= p.size(); ++i) {
      segments_.push_back(sor_segment(p[i], p[i + 1], p[i + 2], p[i + 3]));
      reach_ = std::max(reach_, segments_.back().shell.radii.hi);
    }
    if (segments_.empty()) return;
    low_ = p[1].y;
    high_ = p[p.size() - 2].y;
    base_radius_ = p[1].x;
    cap_radius_ = p[p.size() - 2].x;
  }

  template <class Sink>
  void scan(const Ray& ray, Interval, Sink&& sink) const {
    if (segments_.empty()) return;
    Ray local = to_world_->inverse_ray(ray);
    const double length = glm::length(local.direction);
    local.direction /= length;
    const double shift = glm::dot(dvec3(0, 0.5 * (low_ + high_), 0) - local.origin, local.direction);
    local.origin += shift * local.direction;
    if (!open_ && std::abs(local.direction.y) > kEpsilon) {
      scan_disc(local, low_, base_radius_, base_part(), shift, length, sink);
      scan_disc(local, high_, cap_radius_, base_part() + 1, shift, length, sink);
    }
    for (std::size_t i = 0; i < segments_.size(); ++i)
      if (segments_[i].shell.meets(local)) scan_segment(i, local, shift, length, sink);
  }

  Aabb bounds() const override {
    if (segments_.empty()) return {};
    return to_world_->box({{-reach_, low_, -reach_}, {reach_, high_, reach_}});
  }
  bool inside(const dvec3& point) const override {
    const dvec3 p = to_world_->inverse_point(point);
    for (const SorSegment& segment : segments_) {
      if (!segment.shell.heights.contains(p.y)) continue;
      return p.x * p.x + p.z * p.z <= std::min(segment.at(p.y - segment.shell.heights.lo), reach_ * reach_);
    }
    return false;
  }
  dvec3 normal(const ShapeHit& hit, const dvec3& point) const override {
    if (hit.part >= base_part()) return glm::normalize(to_world_->normal({0, hit.part == base_part() ? -1 : 1, 0}));
    const dvec3 p = to_world_->inverse_point(point);
    const std::array<double, 4>& c = segments_[hit.part].radius2;
    const double h = p.y - segments_[hit.part].shell.heights.lo;
    const double slope = (3 * c[3] * h + 2 * c[2]) * h + c[1];
    return glm::normalize(to_world_->normal({p.x, -0.5 * slope, p.z}));
  }
  dvec2 uv(const ShapeHit& hit, const dvec3& point) const override {
    const dvec3 p = to_world_->inverse_point(point);
    const double u = longitude_share(p.x, p.z);
    const double rho = std::hypot(p.x, p.z);
    if (hit.part == base_part()) return {u, rho / base_radius_ - 1};
    if (hit.part == base_part() + 1) return {u, 2 - rho / cap_radius_};
    const Interval& heights = segments_[hit.part].shell.heights;
    return {u, ((p.y - heights.lo) / (heights.hi - heights.lo) + hit.part) / static_cast<double>(segments_.size())};
  }

 private:
  std::uint32_t base_part() const { return static_cast<std::uint32_t>(segments_.size()); }

  template <class Sink>
  static void scan_disc(const Ray& ray, double height, double radius, std::uint32_t part, double shift, double length,
                        Sink& sink) {
    const double t = (height - ray.origin.y) / ray.direction.y;
    const dvec3 p = ray.at(t);
    if (radius * radius > 1e-4 && p.x * p.x + p.z * p.z <= radius * radius) sink((t + shift) / length, part);
  }

  template <class Sink>
  void scan_segment(std::size_t i, const Ray& ray, double shift, double length, Sink& sink) const {
    const SorSegment& segment = segments_[i];
    const Interval& heights = segment.shell.heights;
    const dvec3& p = ray.origin;
    const dvec3& d = ray.direction;
    const std::array<double, 4>& r = segment.radius2;
    const double h = p.y - heights.lo;
    // x² + z² - r²(h + t dy), Taylor's coefficients about t = 0.
    const std::array<double, 4> c{
        p.x * p.x + p.z * p.z - segment.at(h),
        2 * (p.x * d.x + p.z * d.z) - ((3 * r[3] * h + 2 * r[2]) * h + r[1]) * d.y,
        d.x * d.x + d.z * d.z - (3 * r[3] * h + r[2]) * d.y * d.y,
        -r[3] * d.y * d.y * d.y,
    };
    const double slack = 1e-12 * (heights.hi - heights.lo);
    // The line lies within the segment's heights only for a stretch, and all roots are near: |t| is at most this.
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Interval within{-kInfinity, kInfinity};
    if (std::abs(d.y) > kEpsilon) {
      const double t0 = (heights.lo - slack - p.y) / d.y;
      const double t1 = (heights.hi + slack - p.y) / d.y;
      within = {std::min(t0, t1), std::max(t0, t1)};
    } else if (p.y < heights.lo || p.y > heights.hi) {
      return;
    }
    for (const double root : solve_cubic(c, within)) sink((root + shift) / length, static_cast<std::uint32_t>(i));
  }

  std::vector<SorSegment> segments_;
  double low_ = 0, high_ = 0, reach_ = 0, base_radius_ = 0, cap_radius_ = 0;
  bool open_;
  SharedTransform to_world_;
};

}  // namespace

std::unique_ptr<Shape> build(const Sor& sor, const SharedTransform& to_world, BuildContext&) {
  return std::make_unique<TurnedSurface>(sor, to_world);
}

}  // namespace lute
