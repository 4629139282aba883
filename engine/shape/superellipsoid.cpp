#include "engine/shape/superellipsoid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

constexpr double kReach = 1.01;      // half side of the box the ray is cut to
constexpr double kOnSurface = 1e-10;

// The exponent of a norm. Scenes like round numbers, 2 / 0.25 or 2 / 0.4: a whole power is a few products.
class Exponent {
 public:
  explicit Exponent(double q) : q_(q), inverse_(1 / q) {
    if (q >= 1 && q <= kLargest && q == std::floor(q)) whole_ = static_cast<unsigned>(q);
  }

  double power(double base) const {  // base >= 0
    if (whole_ == 0) return std::pow(base, q_);
    double result = 1;
    for (unsigned rest = whole_;;) {
      if ((rest & 1) != 0) result *= base;
      if ((rest >>= 1) == 0) return result;
      base *= base;
    }
  }
  double root(double of) const { return std::pow(of, inverse_); }
  double value() const { return q_; }

 private:
  static constexpr double kLargest = 64;
  double q_, inverse_;
  unsigned whole_ = 0;  // 0: not a whole number, or a large one
};

// (u^q + v^q)^(1/q) for u, v >= 0, with its derivatives by u and v.
struct PNorm {
  double value, by_u, by_v;
};

PNorm p_norm(double u, double v, const Exponent& q) {
  const double larger = std::max(u, v);
  if (larger == 0) return {0, 1, 1};
  const double ratio = std::min(u, v) / larger;
  const double power = q.power(ratio);
  if (power < 1e-17) return u > v ? PNorm{u, 1, 0} : PNorm{v, 0, 1};
  const double factor = q.root(1 + power);
  const double by_larger = factor / (1 + power);
  const double by_smaller = by_larger * power / ratio;
  return u > v ? PNorm{larger * factor, by_larger, by_smaller} : PNorm{larger * factor, by_smaller, by_larger};
}

class RoundedBox final : public ScannedShape<RoundedBox> {
 public:
  RoundedBox(const Superellipsoid& shape, const SharedTransform& to_world)
      : alpha_(2 / shape.east_west), gamma_(2 / shape.north_south), to_world_(to_world) {}

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    Ray local = to_world_->inverse_ray(ray);
    const double length = glm::length(local.direction);
    local.direction /= length;
    Interval stretch{range.lo * length, range.hi * length};
    if (!cut_by_box(local, stretch)) return;
    if (convex()) {
      scan_convex(local, stretch, 1 / length, sink);
    } else {
      scan_samples(local, stretch, 1 / length, sink);
    }
  }

  Aabb bounds() const override { return to_world_->box({dvec3(-1.0001), dvec3(1.0001)}); }
  bool inside(const dvec3& point) const override { return value(to_world_->inverse_point(point)) < kOnSurface; }
  dvec3 normal(const ShapeHit&, const dvec3& point) const override {
    const dvec3 n = to_world_->normal(gradient(to_world_->inverse_point(point)));
    const double length = glm::length(n);
    return length > 0 ? n / length : dvec3(1, 0, 0);
  }

 private:
  struct Along {
    double f, slope;
  };
  struct Sample {
    double t, f;
  };

  // With exponents of at least 1 the value is a norm minus 1, and so a convex function of the depth: a ray has at most one entry and
  // one exit.
  bool convex() const { return alpha_.value() >= 1 && gamma_.value() >= 1; }

  // With exponents of at most 1 it is a concave function between the planes of symmetry, and cannot dip there.
  bool concave() const { return alpha_.value() <= 1 && gamma_.value() <= 1; }

  // Newton's method from the ends of the stretch never steps over a root of a convex function, and a slope away from 0 before one is
  // found says that there is none.
  template <class Sink>
  void scan_convex(const Ray& ray, Interval stretch, double scale, Sink& sink) const {
    const Along first = along(ray, stretch.lo);
    if (std::abs(first.f) < kOnSurface && sink(stretch.lo * scale, 0)) return;
    if (first.f >= kOnSurface) {
      const double entry = newton(ray, stretch.lo, first, stretch);
      if (std::isnan(entry) || sink(entry * scale, 0)) return;
    } else if (first.f > -kOnSurface && first.slope >= 0) {
      return;
    }
    const Along last = along(ray, stretch.hi);
    if (last.f < kOnSurface) return;
    const double exit = newton(ray, stretch.hi, last, stretch);
    if (!std::isnan(exit)) sink(exit * scale, 0);
  }

  // The root that lies downhill of `t`; NaN if there is none in the stretch.
  double newton(const Ray& ray, double t, Along here, Interval stretch) const {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const bool forward = here.slope < 0;
    if (forward != (t == stretch.lo)) return kNone;
    for (int step = 0; step < 100; ++step) {
      const double next = t - here.f / here.slope;
      if (!stretch.contains(next)) return kNone;
      if (next == t) return t;
      const double before = t;
      t = next;
      here = along(ray, t);
      // Below the rounding of the value itself the next step says nothing any more.
      if (here.f <= 4 * std::numeric_limits<double>::epsilon() || std::abs(t - before) <= 1e-16 * std::abs(t)) return t;
      if ((here.slope < 0) != forward) return kNone;
    }
    return here.f < kOnSurface ? t : kNone;
  }

  // The value at a depth and its derivative by the depth.
  Along along(const Ray& ray, double t) const {
    const dvec3 p = ray.at(t);
    const PNorm ring = p_norm(std::abs(p.x), std::abs(p.y), alpha_);
    const PNorm whole = p_norm(ring.value, std::abs(p.z), gamma_);
    const double ring_slope = ring.by_u * std::copysign(ray.direction.x, p.x * ray.direction.x) +
                              ring.by_v * std::copysign(ray.direction.y, p.y * ray.direction.y);
    return {whole.value - 1, whole.by_u * ring_slope + whole.by_v * std::copysign(ray.direction.z, p.z * ray.direction.z)};
  }

  template <class Sink>
  void scan_samples(const Ray& local, Interval stretch, double scale, Sink& sink) const {
    std::array<double, 11> samples;
    const std::size_t count = sample_depths(local, stretch, samples);
    Sample before{samples[0], value(local.at(samples[0]))};
    if (std::abs(before.f) < kOnSurface && sink(before.t * scale, 0)) return;
    for (std::size_t i = 1; i < count; ++i) {
      const Sample here{samples[i], value(local.at(samples[i]))};
      Sample dip;
      if (std::abs(here.f) < kOnSurface) {
        if (sink(here.t * scale, 0)) return;
      } else if (before.f * here.f < 0 && std::abs(before.f) >= kOnSurface) {
        if (sink(crossing(local, before, here) * scale, 0)) return;
      } else if (before.f > 0 && here.f > 0 && !concave() && finds_dip(local, before, here, dip)) {
        if (sink(crossing(local, before, dip) * scale, 0) || sink(crossing(local, dip, here) * scale, 0)) return;
      }
      before = here;
    }
  }

  double value(const dvec3& p) const {
    return p_norm(p_norm(std::abs(p.x), std::abs(p.y), alpha_).value, std::abs(p.z), gamma_).value - 1;
  }

  // Along the outward normal on the surface, of any length.
  dvec3 gradient(const dvec3& p) const {
    const double x = std::abs(p.x);
    const double y = std::abs(p.y);
    const double zeta = gamma_.power(std::abs(p.z));
    const auto over = [](double share, double coordinate) { return coordinate == 0 ? 0 : share / coordinate; };
    const double rho = x > y ? alpha_.power(y / x) : y > 0 ? alpha_.power(x / y) : 1;
    const double rest = 1 - zeta;
    return {over(x > y ? rest : rest * rho, p.x), over(x > y ? rest * rho : rest, p.y), over(zeta, p.z) * (1 + rho)};
  }

  static bool cut_by_box(const Ray& ray, Interval& stretch) {
    for (int axis = 0; axis < 3; ++axis) {
      const double p = ray.origin[axis];
      const double d = ray.direction[axis];
      if (d == 0) {
        if (std::abs(p) > kReach) return false;
        continue;
      }
      double near = (-kReach - p) / d;
      double far = (kReach - p) / d;
      if (near > far) std::swap(near, far);
      stretch = {std::max(stretch.lo, near), std::min(stretch.hi, far)};
    }
    return !stretch.empty();
  }

  // The ends of the stretch and its crossings with the nine planes of symmetry, ascending.
  static std::size_t sample_depths(const Ray& ray, Interval stretch, std::array<double, 11>& samples) {
    static const std::array<dvec3, 9> kPlanes{dvec3(1, 1, 0), dvec3(1, -1, 0), dvec3(1, 0, 1), dvec3(1, 0, -1), dvec3(0, 1, 1),
                                              dvec3(0, 1, -1), dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)};
    samples[0] = stretch.lo;
    samples[1] = stretch.hi;
    std::size_t count = 2;
    for (const dvec3& plane : kPlanes) {
      const double t = -glm::dot(plane, ray.origin) / glm::dot(plane, ray.direction);
      if (t > stretch.lo && t < stretch.hi) samples[count++] = t;
    }
    std::sort(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }

  // Golden section search for a point with a negative value between two points with positive ones, ended early where the value
  // falls towards an end: then the least value is that end's.
  bool finds_dip(const Ray& ray, Sample first, Sample last, Sample& dip) const {
    constexpr double kGolden = 0.3819660112501051;
    double lo = first.t;
    double hi = last.t;
    const double width = hi - lo;
    if (!(width > 0)) return false;
    const auto f = [&](double t) { return value(ray.at(t)); };
    const double step = 1e-4 * width;
    if (f(lo + step) >= first.f || f(hi - step) >= last.f) return false;
    double a = lo + kGolden * width;
    double b = hi - kGolden * width;
    double fa = f(a);
    double fb = f(b);
    while (hi - lo > 1e-9 * width) {
      if (fa < 0 || fb < 0) {
        dip = fa < 0 ? Sample{a, fa} : Sample{b, fb};
        return true;
      }
      if (fa < fb) {
        hi = b;
        b = a;
        fb = fa;
        a = lo + kGolden * (hi - lo);
        fa = f(a);
      } else {
        lo = a;
        a = b;
        fa = fb;
        b = hi - kGolden * (hi - lo);
        fb = f(b);
      }
    }
    return false;
  }

  // Newton's method between samples of opposite sign, with halving wherever it leaves them or slows down.
  double crossing(const Ray& ray, Sample first, Sample last) const {
    double lo = first.t;
    double hi = last.t;
    double t = lo + (hi - lo) * (first.f / (first.f - last.f));
    double step_before = hi - lo;
    bool newton_before = false;
    for (int count = 0; count < 100; ++count) {
      const Along here = along(ray, t);
      if (std::abs(here.f) <= 4 * std::numeric_limits<double>::epsilon()) return t;
      ((here.f > 0) == (first.f > 0) ? lo : hi) = t;
      double next = t - here.f / here.slope;
      const bool newton = next >= lo && next <= hi && 2 * std::abs(next - t) <= step_before;
      if (!newton) next = 0.5 * (lo + hi);
      const double step = std::abs(next - t);
      // The steps shrink as their squares do: the one after this would be below the rounding.
      if (newton && newton_before && step * step * step <= 1e-16 * step_before * step_before) return next;
      if (hi - lo <= 4e-16 * std::abs(hi)) return next;
      t = next;
      step_before = step;
      newton_before = newton;
    }
    return t;
  }

  Exponent alpha_, gamma_;
  SharedTransform to_world_;
};

}  // namespace

std::unique_ptr<Shape> build(const Superellipsoid& shape, const SharedTransform& to_world, BuildContext&) {
  return std::make_unique<RoundedBox>(shape, to_world);
}

}  // namespace lute
