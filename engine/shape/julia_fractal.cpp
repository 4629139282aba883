#include "engine/shape/julia_fractal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/shape/julia_algebra.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

using Algebra = JuliaFractal::Algebra;
using Function = JuliaFractal::Function;

constexpr double kFinest = 1e-7;  // bracket in which a hit is found

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
    radius_ = quaternion_ ? std::min(2.0, 1 + glm::length(f_.constant) + 1e-7) : 4;
    escape_ = quaternion_ ? radius_ * radius_ + 1e-7 : 16;
    squares_ = !quaternion_ && f_.function == Function::kSqr;
    by_function_ = !quaternion_ && f_.function >= Function::kExp;
    const double ratio = f_.function == Function::kCube ? 3 : 2;
    for (std::size_t i = 0; i <= steps_; ++i) shares_.push_back(std::pow(ratio, -static_cast<double>(i)));
  }

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    Ray local = to_world_->inverse_ray(ray);
    const double length = glm::length(local.direction);
    local.direction /= length;
    const double b = -glm::dot(local.origin, local.direction);
    const dvec3 apart = local.origin + b * local.direction;
    const double h = radius_ * radius_ - glm::dot(apart, apart);
    if (!(h > kEpsilon)) return;
    const double end = b + std::sqrt(h);
    if (end < kFinest) return;
    double t = std::max(b - std::sqrt(h), kFinest);
    // In local units; hits behind the range are not looked for.
    const Interval wanted{range.lo * length, range.hi * length * (1 + 1e-9)};
    if (t > wanted.hi) return;

    thread_local Orbit orbit;
    if (orbit.size() != steps_ + 1 || by_function_) orbit.assign(steps_ + 1, dvec4(0));
    double step = 0;
    bool inside = evaluate(local.at(t), local.direction, orbit, step);
    if (inside) {
      t += 2 * kFinest;
      if (t > end) return;
      inside = evaluate(local.at(t), local.direction, orbit, step);
    }
    for (;;) {
      step = std::max(step, least_step_);
      if (t > wanted.hi) return;
      t += step;
      if (t > end) return;
      double next = 0;
      if (evaluate(local.at(t), local.direction, orbit, next) == inside) {
        step = next;
        continue;
      }
      if (!depth_matters<Sink>() && t - step > wanted.lo && t < range.hi * length) {
        sink((t - 0.5 * step) / length, 0);
        return;
      }
      t = bracket(local, t - step, step, inside, orbit);
      const double far = t + step;
      const double hit = inside ? t : far;
      // The normal of a function depends on what the array of iterates still holds; others are computed when they are asked for.
      dvec3 kept = local.at(hit);
      if (by_function_) {
        escape_step(plain_start(kept), orbit);
        kept = hypercomplex_normal(orbit, steps_);
      }
      if (sink(hit / length, 0, std::array<double, 3>{kept.x, kept.y, kept.z})) return;
      inside = !inside;
      t = far;
      step = least_step_;
    }
  }

  Aabb bounds() const override {
    dvec3 reach;
    for (int axis = 0; axis < 3; ++axis)
      reach[axis] =
          radius_ * glm::length(dvec3(to_world_->linear[0][axis], to_world_->linear[1][axis], to_world_->linear[2][axis]));
    return {to_world_->translation - reach, to_world_->translation + reach};
  }
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
  dvec4 start(const dvec3& p) const {
    return {p, (f_.slice_distance - glm::dot(dvec3(f_.slice), p)) / f_.slice.w};
  }
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

  // The same for quaternions, without a record of the orbit: the step, and the product of the squared lengths of what came before it.
  std::size_t quaternion_escape(const dvec4& z, double& norm, double& product) const {
    return f_.function == Function::kCube ? quaternion_escape_of<true>(z, norm, product) : quaternion_escape_of<false>(z, norm, product);
  }
  template <bool kCube>
  std::size_t quaternion_escape_of(const dvec4& start, double& norm, double& product) const {
    const dvec4 c = f_.constant;
    const double escape = escape_;
    double x = start.x, y = start.y, z = start.z, w = start.w, lengths = 1;
    for (std::size_t i = 1; i <= steps_; ++i) {
      const double d = y * y + z * z + w * w, x2 = x * x, size = x2 + d;
      if (size > escape) {
        norm = size;
        product = lengths;
        return i;
      }
      lengths *= size;
      const double k = kCube ? 3 * x2 - d : 2 * x;
      x = (kCube ? x * (x2 - 3 * d) : x2 - d) + c.x;
      y = k * y + c.y;
      z = k * z + c.z;
      w = k * w + c.w;
    }
    return 0;
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
    double norm, product;
    if (squares_) return squares_escape<false>(ComplexPair(start(p)), norm) == 0;
    return quaternion_ ? quaternion_escape(start(p), norm, product) == 0 : escape_step(plain_start(p), orbit) == 0;
  }

  // Whether the point is inside; `step` becomes how far the ray may advance.
  bool evaluate(const dvec3& p, const dvec3& direction, Orbit& orbit, double& step) const {
    if (quaternion_) {
      // The length of a product of quaternions is the product of their lengths.
      double norm, product;
      const std::size_t escaped = quaternion_escape(start(p), norm, product);
      step = escaped == 0 ? least_step_ : shares_[escaped] * std::log(norm) / std::sqrt(product);
      return escaped == 0;
    }
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

  // Halves [t, t + step], whose ends differ; returns the near end of the bracket, `step` becomes its length.
  double bracket(const Ray& ray, double t, double& step, bool inside, Orbit& orbit) const {
    while (step > kFinest) {
      step *= 0.5;
      if (stays(ray.at(t + step), orbit) == inside) t += step;
    }
    return t;
  }

  dvec3 quaternion_normal(const Orbit& orbit) const {
    dvec3 n;
    for (int axis = 0; axis < 3; ++axis) {
      dvec4 v(0);
      v[axis] = 1;
      for (std::size_t j = 0; j < steps_; ++j) v = f_.function == Function::kCube ? cube_slope(orbit[j], v) : square_slope(orbit[j], v);
      n[axis] = glm::dot(v, orbit[steps_]);
    }
    return n;
  }

  static dvec4 square_slope(const dvec4& z, const dvec4& v) {
    return {v.x * z.x - v.y * z.y - v.z * z.z - v.w * z.w, v.x * z.y + v.y * z.x, v.x * z.z + v.z * z.x, v.x * z.w + v.w * z.x};
  }
  static dvec4 cube_slope(const dvec4& z, const dvec4& v) {
    const double d = z.y * z.y + z.z * z.z + z.w * z.w;
    const double tau = 2 * (v.y * z.y + v.z * z.z + v.w * z.w);
    const double tau2 = 6 * z.x * v.x - tau;
    const double k = 3 * z.x * z.x - d;
    return {3 * ((z.x * z.x - d) * v.x - z.x * tau), v.y * k + z.y * tau2, v.z * k + z.z * tau2, v.w * k + z.w * tau2};
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
  double radius_ = 2, escape_ = 4;
  bool quaternion_ = true, squares_ = false, by_function_ = false;
  SharedTransform to_world_;
};

}  // namespace

std::unique_ptr<Shape> build(const JuliaFractal& fractal, const SharedTransform& to_world, BuildContext&) {
  return std::make_unique<JuliaSet>(fractal, to_world);
}

}  // namespace lute
