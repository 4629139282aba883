#include "engine/shape/poly.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/math/polynomial.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

constexpr double kInsideTolerance = 1e-4;

// A polynomial in the ray's parameter under construction, ascending.
struct AlongRay {
  std::array<double, Poly::kMaxOrder + 1> c;
  int degree = 0;

  explicit AlongRay(double constant) { c[0] = constant; }

  // this := this * (p + t d) + other
  void multiply_add(double p, double d, const AlongRay& other) {
    const auto n = static_cast<std::size_t>(degree);
    c[n + 1] = c[n] * d;
    for (std::size_t i = n; i > 0; --i) c[i] = c[i] * p + c[i - 1] * d;
    c[0] *= p;
    ++degree;
    for (int i = 0; i <= other.degree; ++i) c[static_cast<std::size_t>(i)] += other.c[static_cast<std::size_t>(i)];
  }
};

class PolySurface final : public ScannedShape<PolySurface> {
 public:
  PolySurface(const Poly& poly, const Transform& to_world)
      : order_(poly.order), coefficients_(poly.coefficients), to_world_(to_world) {}

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    const Ray local = to_world_.identity() ? ray : to_world_.inverse_ray(ray);
    const double length = glm::length(local.direction);
    const dvec3 d = local.direction / length;
    const double shift = -glm::dot(local.origin, d);
    const AlongRay along = expand(local.origin + shift * d, d);
    const Interval within{range.lo * length - shift, range.hi * length - shift};
    const auto emit = [&](const auto& roots) {
      for (std::size_t i = roots.count; i-- > 0;) sink((roots.t[i] + shift) / length, 0);
    };
    const auto& c = along.c;
    switch (order_) {
      case 2: return emit(solve_quadratic({c[0], c[1], c[2]}, within));
      case 3: return emit(solve_cubic({c[0], c[1], c[2], c[3]}, within));
      case 4: return emit(solve_quartic({c[0], c[1], c[2], c[3], c[4]}, within));
      default: return emit(solve_polynomial({c.data(), static_cast<std::size_t>(order_) + 1}, within));
    }
  }

  Aabb bounds() const override { return Aabb::infinite(); }
  bool inside(const dvec3& point) const override { return value(to_world_.inverse_point(point)) < kInsideTolerance; }
  dvec3 normal(const ShapeHit&, const dvec3& point) const override {
    const dvec3 gradient = to_world_.normal(gradient_at(to_world_.inverse_point(point)));
    const double length = glm::length(gradient);
    return length > 0 ? gradient / length : dvec3(1, 0, 0);
  }
  bool tests_own_box() const override { return false; }

 private:
  // Horner's rule, x outermost; coefficients are met in the order they are kept in.
  AlongRay expand(const dvec3& p, const dvec3& d) const {
    std::size_t next = 0;
    AlongRay fx(0);
    for (int i = order_; i >= 0; --i) {
      AlongRay fy(0);
      for (int j = order_ - i; j >= 0; --j) {
        AlongRay fz(coefficients_[next++]);
        for (int k = order_ - i - j; k > 0; --k) fz.multiply_add(p.z, d.z, AlongRay(coefficients_[next++]));
        if (j == order_ - i) {
          fy = fz;
        } else {
          fy.multiply_add(p.y, d.y, fz);
        }
      }
      if (i == order_) {
        fx = fy;
      } else {
        fx.multiply_add(p.x, d.x, fy);
      }
    }
    return fx;
  }

  double value(const dvec3& p) const {
    std::size_t next = 0;
    double fx = 0;
    for (int i = order_; i >= 0; --i) {
      double fy = 0;
      for (int j = order_ - i; j >= 0; --j) {
        double fz = 0;
        for (int k = order_ - i - j; k >= 0; --k) fz = fz * p.z + coefficients_[next++];
        fy = fy * p.y + fz;
      }
      fx = fx * p.x + fy;
    }
    return fx;
  }

  dvec3 gradient_at(const dvec3& p) const {
    std::size_t next = 0;
    double fx = 0;
    dvec3 g(0);
    for (int i = order_; i >= 0; --i) {
      double fy = 0;
      double fy_y = 0;
      double fy_z = 0;
      for (int j = order_ - i; j >= 0; --j) {
        double fz = 0;
        double fz_z = 0;
        for (int k = order_ - i - j; k >= 0; --k) {
          fz_z = fz_z * p.z + fz;
          fz = fz * p.z + coefficients_[next++];
        }
        fy_y = fy_y * p.y + fy;
        fy_z = fy_z * p.y + fz_z;
        fy = fy * p.y + fz;
      }
      g.x = g.x * p.x + fx;
      g.y = g.y * p.x + fy_y;
      g.z = g.z * p.x + fy_z;
      fx = fx * p.x + fy;
    }
    return g;
  }

  int order_;
  std::vector<double> coefficients_;
  Transform to_world_;
};

}  // namespace

std::unique_ptr<Shape> build(const Poly& poly, const Transform& to_world, BuildContext&) {
  return std::make_unique<PolySurface>(poly, to_world);
}

}  // namespace lute
