#include "engine/shape/julia_fractal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/shape/julia_algebra.hpp"
#include "engine/shape/quaternion_orbit.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

using Algebra = JuliaFractal::Algebra;
using Function = JuliaFractal::Function;

constexpr double kFinest = 1e-7;  // bracket in which a hit is found
constexpr double kReachMargin = 1 + 1e-9;

// The iterates of one point; entries behind an escape are those of earlier points on the same ray, as the reference's normal sees
// them.
using Orbit = std::vector<dvec4>;

// A hypercomplex number as the two complex numbers whose sums and products are its own; the mean of their squared lengths is its.
struct ComplexPair {
  dvec2 a{0}, b{0};
  ComplexPair() = default;
  ComplexPair(const dvec2& first, const dvec2& second) : a(first), b(second) {}
  explicit ComplexPair(const dvec4& z) : a(z.x - z.w, z.y + z.z), b(z.x + z.w, z.y - z.z) {}
  void multiply(const ComplexPair& z) {
    a = {a.x * z.a.x - a.y * z.a.y, a.x * z.a.y + a.y * z.a.x};
    b = {b.x * z.b.x - b.y * z.b.y, b.x * z.b.y + b.y * z.b.x};
  }
};

// A hit keeps its place in the fractal's space, or for functions its normal there.
class JuliaSet final : public ScannedShape<JuliaSet> {
 public:
  JuliaSet(const JuliaFractal& fractal, const SharedTransform& to_world)
      : f_(fractal), steps_(static_cast<std::size_t>(fractal.max_iteration)), least_step_(1 / fractal.precision), to_world_(to_world) {
    quaternion_ = f_.algebra == Algebra::kQuaternion;
    radius_ = search_radius(f_);
    escape_ = quaternion_ ? radius_ * radius_ + 1e-7 : 16;
    squares_ = !quaternion_ && f_.function == Function::kSqr;
    by_function_ = !quaternion_ && f_.function >= Function::kExp;
    const double ratio = f_.function == Function::kCube ? 3 : 2;
    for (std::size_t i = 0; i <= steps_; ++i) shares_.push_back(std::pow(ratio, -static_cast<double>(i)));
    reach_ = reach();
    // What leaves after the first step is at most as long as the image of the longest that does not.
    const double most = 2 * std::log(std::pow(escape_, ratio / 2) + glm::length(f_.constant)) / least_step_;
    for (std::size_t i = 0; i <= steps_; ++i)
      steps_least_.push_back(i < 2 ? std::numeric_limits<double>::infinity() : std::pow(shares_[i] * most, 2) * (1 + 1e-9));
    orbit_ = {f_.constant, f_.function == Function::kCube, steps_, escape_};
  }

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    March march{to_world_->inverse_ray(ray)};
    Ray& local = march.ray;
    march.length = glm::length(local.direction);
    local.direction /= march.length;
    const double b = -glm::dot(local.origin, local.direction);
    const dvec3 apart = local.at(b);
    const double h = radius_ * radius_ - glm::dot(apart, apart);
    if (!(h > kEpsilon)) return;
    march.begin = std::max(b - std::sqrt(h), kFinest);
    march.end = b + std::sqrt(h);
    march.range = range;
    march.wanted = {range.lo * march.length, range.hi * march.length * (1 + 1e-9)};
    if (march.end < kFinest || march.begin > march.wanted.hi) return;
    // Only points that begin within `reach_` stay.
    const dvec4 nearest = start(apart), direction = along(local.direction);
    const double per_depth = glm::dot(direction, direction), middle = -glm::dot(nearest, direction) / per_depth;
    const dvec4 four_apart = nearest + middle * direction;
    const double four_h = reach_ * reach_ - glm::dot(four_apart, four_apart);
    if (!(four_h > 0)) return;
    const double half = std::sqrt(four_h / per_depth);
    march.outside_from = b + middle + half;
    if (b + middle - half > march.wanted.hi) return;
    if (quaternion_) return scan_line(QuaternionLine(*this, {orbit_, nearest, direction, b}), march, sink);
    scan_line(OrbitLine(*this, local), march, sink);
  }

  Aabb bounds() const override {
    dvec3 reach;
    const dmat3& linear = to_world_->linear;
    for (int axis = 0; axis < 3; ++axis)
      reach[axis] = std::min(radius_, reach_) * glm::length(dvec3(linear[0][axis], linear[1][axis], linear[2][axis]));
    return {to_world_->translation - reach, to_world_->translation + reach};
  }
  bool prefers_clipped_range() const override { return true; }
  bool inside(const dvec3& point) const override {
    thread_local Orbit orbit;
    orbit.resize(steps_ + 1);
    return stays(to_world_->inverse_point(point), orbit);
  }
  dvec3 normal(const ShapeHit& hit, const dvec3&) const override {
    dvec3 local(hit.data[0], hit.data[1], hit.data[2]);
    if (!by_function_) {
      thread_local Orbit orbit;
      orbit.assign(steps_ + 1, dvec4(0));
      escape_step(plain_start(local), orbit);
      local = quaternion_ ? quaternion_normal(orbit) : hypercomplex_normal(orbit, steps_);
    }
    const dvec3 n = to_world_->normal(local);
    const double length = glm::length(n);
    return length > 0 ? n / length : dvec3(1, 0, 0);
  }

 private:
  // The part of a ray to look for hits in, in the fractal's space, where depths are `length` times those in the world.
  struct March {
    Ray ray;
    double length = 1;
    double begin = 0, end = 0;
    double outside_from = 0;  // no point is inside from this depth on
    Interval range{}, wanted{};  // in the world; in local units, hits behind are not looked for
  };

  dvec4 start(const dvec3& p) const { return {p, (f_.slice_distance - glm::dot(dvec3(f_.slice), p)) / f_.slice.w}; }
  // How it changes along a direction.
  dvec4 along(const dvec3& d) const { return {d, -glm::dot(dvec3(f_.slice), d) / f_.slice.w}; }

  // A length that every starting point whose orbit stays is below: a longer one is followed by points that are longer than what escapes.
  double reach() const {
    if (quaternion_) return reach_of(std::sqrt(escape_), f_.function == Function::kCube ? 3 : 2, glm::length(f_.constant));
    if (!squares_) return std::sqrt(escape_) * kReachMargin;
    // Of two complex numbers, both: the mean of their squares may escape.
    const ComplexPair c(f_.constant);
    const double alone = std::sqrt(2 * escape_), a = reach_of(alone, 2, glm::length(c.a)), b = reach_of(alone, 2, glm::length(c.b));
    return std::sqrt(0.5 * (a * a + b * b));
  }
  double reach_of(double escape, double power, double constant) const {
    double reach = escape, last = escape;
    for (std::size_t i = 1; i < steps_; ++i) reach = std::min(reach, last = std::pow(last + constant, 1 / power));
    return reach * kReachMargin;
  }

  // From step to step along a line through the fractal.
  template <class Line, class Sink>
  void scan_line(const Line& line, const March& march, Sink& sink) const {
    double t = march.begin, step = 0;
    if (t > march.outside_from) return;
    bool inside = line.evaluate(t, step);
    if (inside) {
      t += 2 * kFinest;
      if (t > march.end) return;
      inside = line.evaluate(t, step);
    }
    for (;;) {
      step = std::max(step, least_step_);
      if (t > march.wanted.hi) return;
      t += step;
      if (t > march.end || (t > march.outside_from && !inside)) return;
      double next = 0;
      if (line.evaluate(t, next) == inside) {
        step = next;
        continue;
      }
      if (!depth_matters<Sink>() && t - step > march.wanted.lo && t < march.range.hi * march.length) {
        sink((t - 0.5 * step) / march.length, 0);
        return;
      }
      t = bracket(line, t - step, step, inside);
      const double far = t + step;
      const double hit = inside ? t : far;
      const dvec3 kept = line.kept(march.ray.at(hit));
      if (sink(hit / march.length, 0, std::array<double, 3>{kept.x, kept.y, kept.z})) return;
      inside = !inside;
      t = far;
      step = least_step_;
    }
  }

  // Halves [t, t + step], whose ends differ; returns the near end of the bracket, `step` becomes its length.
  template <class Line>
  static double bracket(const Line& line, double t, double& step, bool inside) {
    while (step > kFinest) {
      step *= 0.5;
      if (line.stays(t + step) == inside) t += step;
    }
    return t;
  }

  class QuaternionLine {
   public:
    QuaternionLine(const JuliaSet& set, const QuaternionLengthsAlong& lengths) : set_(set), lengths_(lengths) {}
    // Whether the point is inside; `step` becomes how far the ray may advance, if that is more than the least.
    bool evaluate(double t, double& step) const {
      double norm, product;
      const std::size_t escaped = set_.orbit_.escape(lengths_.at(t), norm, product);
      step = set_.least_step_;
      if (escaped == 0) return true;
      if (product > set_.steps_least_[escaped]) return false;
      // The length of a product of quaternions is the product of their lengths.
      step = set_.shares_[escaped] * std::log(norm) / std::sqrt(std::abs(product));
      return false;
    }
    bool stays(double t) const { return set_.orbit_.stays(lengths_.at(t)); }
    const dvec3& kept(const dvec3& hit) const { return hit; }

   private:
    const JuliaSet& set_;
    QuaternionLengthsAlong lengths_;
  };

  // All others.
  class OrbitLine {
   public:
    OrbitLine(const JuliaSet& set, const Ray& ray) : set_(set), ray_(ray), orbit_(orbit_of_thread()) {
      if (orbit_.size() != set.steps_ + 1 || set.by_function_) orbit_.assign(set.steps_ + 1, dvec4(0));
    }
    bool evaluate(double t, double& step) const { return set_.evaluate(ray_.at(t), ray_.direction, orbit_, step); }
    bool stays(double t) const { return set_.stays(ray_.at(t), orbit_); }
    // The normal of a function depends on what the array of iterates still holds; others are computed when they are asked for.
    dvec3 kept(const dvec3& hit) const {
      if (!set_.by_function_) return hit;
      set_.escape_step(set_.plain_start(hit), orbit_);
      return set_.hypercomplex_normal(orbit_, set_.steps_);
    }

   private:
    static Orbit& orbit_of_thread() {
      thread_local Orbit orbit;
      return orbit;
    }
    const JuliaSet& set_;
    const Ray& ray_;
    Orbit& orbit_;
  };

  // The inside test of functions begins with y in the place of z (§7.3).
  dvec4 plain_start(const dvec3& p) const { return start(by_function_ ? dvec3(p.x, p.y, p.y) : p); }

  // The step, from 1, before which the orbit has left the ball, or 0 if it never does. One loop for each map.
  template <class Image>
  std::size_t escape_step_of(dvec4 z, dvec4* orbit, Image&& image) const {
    const dvec4 constant = f_.constant;
    orbit[0] = z;
    for (std::size_t i = 1; i <= steps_; ++i) {
      if (glm::dot(z, z) > escape_) return i;
      z = image(z) + constant;
      orbit[i] = z;
    }
    return 0;
  }
  std::size_t escape_step(const dvec4& z, Orbit& orbits) const {
    dvec4* const orbit = orbits.data();
    if (quaternion_) {
      if (f_.function == Function::kCube) return escape_step_of(z, orbit, [](const dvec4& q) { return quaternion_cube(q); });
      return escape_step_of(z, orbit, [](const dvec4& q) { return quaternion_square(q); });
    }
    if (f_.function == Function::kReciprocal) return escape_step_of(z, orbit, [](const dvec4& q) { return hypercomplex_reciprocal(q); });
    if (!by_function_) return escape_step_of(z, orbit, [](const dvec4& q) { return hypercomplex_square(q); });
    return escape_step_of(z, orbit, [this](const dvec4& q) { return hypercomplex_function(f_.function, f_.exponent, q); });
  }

  // The same for squares of hypercomplex numbers, each taken apart into two complex numbers that do not meet; `along` is the
  // direction whose slope, half of that of the squared length there, is wanted.
  template <bool kWithSlope>
  std::size_t squares_escape(ComplexPair z, double& norm, ComplexPair along = {}, double* slope = nullptr) const {
    const ComplexPair c(f_.constant);
    for (std::size_t i = 1; i <= steps_; ++i) {
      const double axx = z.a.x * z.a.x, ayy = z.a.y * z.a.y, bxx = z.b.x * z.b.x, byy = z.b.y * z.b.y;
      norm = 0.5 * ((axx + ayy) + (bxx + byy));
      if (norm > escape_) {
        // The slope at the starting point has it as a factor too.
        if (kWithSlope && i == 1) along.multiply(z);
        if (kWithSlope) *slope = 0.5 * (glm::dot(along.a, z.a) + glm::dot(along.b, z.b)) / shares_[i - 1];
        return i;
      }
      if (kWithSlope) along.multiply(z);
      z = {dvec2(axx - ayy + c.a.x, 2 * z.a.x * z.a.y + c.a.y), dvec2(bxx - byy + c.b.x, 2 * z.b.x * z.b.y + c.b.y)};
    }
    return 0;
  }

  // The plain inside test of a point.
  bool stays(const dvec3& p, Orbit& orbit) const {
    double norm;
    if (squares_) return squares_escape<false>(ComplexPair(start(p)), norm) == 0;
    return quaternion_ ? orbit_.stays(orbit_.lengths(start(p))) : escape_step(plain_start(p), orbit) == 0;
  }

  // Whether the point is inside; `step` becomes how far the ray may advance. Not for quaternions.
  bool evaluate(const dvec3& p, const dvec3& direction, Orbit& orbit, double& step) const {
    step = least_step_;
    double norm, slope;
    if (squares_) {
      if (squares_escape<true>(ComplexPair(start(p)), norm, ComplexPair(dvec4(direction, 0)), &slope) == 0) return true;
    } else {
      const std::size_t i = escape_step(start(p), orbit);
      if (i == 0) return true;
      norm = glm::dot(orbit[i - 1], orbit[i - 1]);
      slope = glm::dot(hypercomplex_normal(orbit, i - 1), direction);
    }
    const double s = -2 * slope;
    if (slope < -1e-8 && least_step_ * s < norm && norm < 30 * least_step_ * s) step = norm / s;
    return false;
  }

  // The gradient of the last squared length, by the transposed derivatives of the map from the last to the first.
  dvec3 quaternion_normal(const Orbit& orbit) const {
    dvec4 v = orbit[steps_];
    const bool cube = f_.function == Function::kCube;
    for (std::size_t j = steps_; j-- > 0;) v = cube ? turned_cube_slope(orbit[j], v) : turned_square_slope(orbit[j], v);
    return dvec3(v);
  }
  static dvec4 turned_square_slope(const dvec4& z, const dvec4& v) {
    return {v.x * z.x + v.y * z.y + v.z * z.z + v.w * z.w, v.y * z.x - v.x * z.y, v.z * z.x - v.x * z.z, v.w * z.x - v.x * z.w};
  }
  static dvec4 turned_cube_slope(const dvec4& z, const dvec4& v) {
    const double d = z.y * z.y + z.z * z.z + z.w * z.w, x2 = z.x * z.x;
    const double met = v.y * z.y + v.z * z.z + v.w * z.w;
    const double k = 3 * x2 - d, back = 6 * z.x * v.x + 2 * met;
    return {3 * (x2 - d) * v.x + 6 * z.x * met, v.y * k - z.y * back, v.z * k - z.z * back, v.w * k - z.w * back};
  }

  dvec4 other_slope(const dvec4& z) const {
    if (f_.function == Function::kReciprocal) return -hypercomplex_square(hypercomplex_reciprocal(z));
    return by_function_ ? hypercomplex_function(f_.function, f_.exponent, z) : z;
  }

  dvec3 hypercomplex_normal(const Orbit& orbit, std::size_t n) const {
    dvec4 h = orbit[0];
    dvec4 v = orbit[n];
    if (f_.function == Function::kSqr) {
      for (std::size_t j = 1; j < n; ++j) h = hypercomplex_product(h, orbit[j]);
      v *= 1 / shares_[n];
    } else {
      for (std::size_t j = 1; j < n; ++j) h = hypercomplex_product(h, other_slope(orbit[j]));
    }
    return {h.x * v.x + h.y * v.y + h.z * v.z + h.w * v.w, -h.y * v.x + h.x * v.y - h.w * v.z + h.z * v.w,
            -h.z * v.x - h.w * v.y + h.x * v.z + h.y * v.w};
  }

  JuliaFractal f_;
  std::size_t steps_;
  double least_step_;
  std::vector<double> shares_;  // [i]: 2⁻ⁱ or 3⁻ⁱ
  std::vector<double> steps_least_;  // [i]: of quaternions that leave before step i, products of squares above this have the least step
  double radius_ = 2, escape_ = 4;
  double reach_ = 2;  // starting points that are longer leave
  bool quaternion_ = true, squares_ = false, by_function_ = false;
  QuaternionOrbit orbit_{dvec4(0), false, 0, 0};
  SharedTransform to_world_;
};

}  // namespace

double search_radius(const JuliaFractal& fractal) {
  return fractal.algebra == JuliaFractal::Algebra::kQuaternion ? std::min(2.0, 1 + glm::length(fractal.constant) + 1e-7) : 4;
}

std::unique_ptr<Shape> build(const JuliaFractal& fractal, const SharedTransform& to_world, BuildContext&) {
  return std::make_unique<JuliaSet>(fractal, to_world);
}

}  // namespace lute
