#include "engine/shape/sor.hpp"

#include <algorithm>
#include <cmath>

#include "engine/math/polynomial.hpp"
#include "engine/math/root_walk.hpp"
#include "engine/shape/revolution_shell.hpp"
#include "engine/shape/scanned_shape.hpp"
#include "engine/shape/unit_sphere_uv.hpp"

namespace lute {

namespace {

struct SorSegment {
  std::array<double, 4> radius2;  // of the height above heights.lo, ascending
  RevolutionShell shell;
  double outer2, inner2;  // squares of the shell's radii, a little widened

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
  const double slack = 1e-9 * std::max(segment.shell.radii.hi, h);
  const double outer = segment.shell.radii.hi + slack, inner = std::max(0.0, segment.shell.radii.lo - slack);
  segment.outer2 = outer * outer;
  segment.inner2 = inner * inner;
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
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    if (segments_.empty()) return;
    Ray local = to_world_->inverse_ray(ray);
    const double length = glm::length(local.direction);
    local.direction /= length;
    const double shift = glm::dot(dvec3(0, 0.5 * (low_ + high_), 0) - local.origin, local.direction);
    local.origin += shift * local.direction;
    if (std::abs(local.direction.y) <= kEpsilon) {
      for (std::size_t i = 0; i < segments_.size(); ++i)
        if (segments_[i].shell.meets(local)) scan_level_segment(i, local, shift, length, sink);
      return;
    }
    const Passage passage(local);
    Interval wanted{range.lo * length - shift, range.hi * length - shift};
    if (!passage.within({low_, high_}, reach_ * reach_, 1e-9 * (high_ - low_), wanted)) return;
    // True if the sink needs no farther hits.
    const auto found = [&](double t, std::uint32_t part) {
      if (!sink((t + shift) / length, part)) return false;
      wanted.hi = std::min(wanted.hi, t + 1e-9 * std::abs(t + shift));
      return true;
    };
    if (!open_) {
      if (scan_disc(local, low_, base_radius_, base_part(), found) && !depth_matters<Sink>()) return;
      if (scan_disc(local, high_, cap_radius_, base_part() + 1, found) && !depth_matters<Sink>()) return;
    }
    for (std::size_t i = 0; i < segments_.size(); ++i)
      if (scan_segment<depth_matters<Sink>()>(i, local, passage, wanted, found) && !depth_matters<Sink>()) return;
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

  // A ray that is not level, as the axis sees it.
  struct Passage {
    explicit Passage(const Ray& ray)
        : height(ray.origin.y),
          reciprocal(1 / ray.direction.y),
          flat2(ray.direction.x * ray.direction.x + ray.direction.z * ray.direction.z),
          along(ray.origin.x * ray.direction.x + ray.origin.z * ray.direction.z),
          distance2(ray.origin.x * ray.origin.x + ray.origin.z * ray.origin.z),
          across(ray.origin.x * ray.direction.z - ray.origin.z * ray.direction.x) {}

    double radius2(double t) const { return (flat2 * t + 2 * along) * t + distance2; }
    // Narrows `depths` to where the ray is between two heights, widened by a slack, and within a radius; false if there is nothing left.
    bool within(Interval heights, double outer2, double slack, Interval& depths) const {
      const double a = (heights.lo - slack - height) * reciprocal, b = (heights.hi + slack - height) * reciprocal;
      depths = {std::max(depths.lo, std::min(a, b)), std::min(depths.hi, std::max(a, b))};
      outer2 *= 1 + 1e-9;
      if (!(flat2 > 0)) return distance2 <= outer2 && !depths.empty();
      const double square = flat2 * outer2 - across * across;
      if (!(square >= 0)) return false;
      const double half = std::sqrt(square);
      depths = {std::max(depths.lo, (-along - half) / flat2), std::min(depths.hi, (-along + half) / flat2)};
      return !depths.empty();
    }

    double height, reciprocal, flat2, along, distance2, across;
  };

  template <class Found>
  static bool scan_disc(const Ray& ray, double height, double radius, std::uint32_t part, const Found& found) {
    const double t = (height - ray.origin.y) / ray.direction.y;
    const dvec3 p = ray.at(t);
    return radius * radius > 1e-4 && p.x * p.x + p.z * p.z <= radius * radius && found(t, part);
  }

  // x² + z² - r²(y), Taylor's coefficients about t = 0.
  static std::array<double, 4> equation(const SorSegment& segment, const Ray& ray) {
    const dvec3& p = ray.origin;
    const dvec3& d = ray.direction;
    const std::array<double, 4>& r = segment.radius2;
    const double h = p.y - segment.shell.heights.lo;
    return {
        p.x * p.x + p.z * p.z - segment.at(h),
        2 * (p.x * d.x + p.z * d.z) - ((3 * r[3] * h + 2 * r[2]) * h + r[1]) * d.y,
        d.x * d.x + d.z * d.z - (3 * r[3] * h + r[2]) * d.y * d.y,
        -r[3] * d.y * d.y * d.y,
    };
  }

  template <bool kExact, class Found>
  bool scan_segment(std::size_t i, const Ray& ray, const Passage& passage, Interval depths, const Found& found) const {
    const SorSegment& segment = segments_[i];
    const Interval& heights = segment.shell.heights;
    if (!passage.within(heights, segment.outer2, 1e-12 * (heights.hi - heights.lo), depths)) return false;
    // Between its ends the ray is nowhere farther from the axis than at one of them.
    if (std::max(passage.radius2(depths.lo), passage.radius2(depths.hi)) < segment.inner2) return false;
    const std::array<double, 4> c = equation(segment, {ray.at(depths.lo), ray.direction});
    return walk_roots<kExact>(c, {0, depths.hi - depths.lo},
                              [&](double root) { return found(depths.lo + root, static_cast<std::uint32_t>(i)); });
  }

  template <class Sink>
  void scan_level_segment(std::size_t i, const Ray& ray, double shift, double length, Sink& sink) const {
    const Interval& heights = segments_[i].shell.heights;
    if (!heights.contains(ray.origin.y)) return;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double root : solve_cubic(equation(segments_[i], ray), {-kInfinity, kInfinity}))
      sink((root + shift) / length, static_cast<std::uint32_t>(i));
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
