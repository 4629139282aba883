#include "engine/shape/poly.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/math/certified_roots.hpp"
#include "engine/math/polynomial.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

constexpr double kInsideTolerance = 1e-4;

// A polynomial in the ray's parameter under construction, ascending. `Capacity` is the highest degree it can take.
template <int Capacity>
struct AlongRay {
  std::array<double, Capacity + 1> c;

  // this := this * (p + t d) + constant, for a polynomial of degree n
  void multiply_add(int degree, double p, double d, double constant) {
    const auto n = static_cast<std::size_t>(degree);
    c[n + 1] = c[n] * d;
    for (std::size_t i = n; i > 0; --i) c[i] = c[i] * p + c[i - 1] * d;
    c[0] = c[0] * p + constant;
  }
  // this := this * (p + t d) + other, where other has degree n + 1
  void multiply_add(int degree, double p, double d, const AlongRay& other) {
    multiply_add(degree, p, d, other.c[0]);
    for (std::size_t i = 1; i <= static_cast<std::size_t>(degree) + 1; ++i) c[i] += other.c[i];
  }
};

class PolySurface final : public ScannedShape<PolySurface> {
 public:
  PolySurface(const Poly& poly, const SharedTransform& to_world)
      : order_(poly.order), coefficients_(poly.coefficients), to_world_(to_world) {
    note_terms();
  }

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    const Ray local = to_world_.identity() ? ray : to_world_->inverse_ray(ray);
    const double length = glm::length(local.direction);
    const dvec3 d = local.direction / length;
    const double shift = -glm::dot(local.origin, d);
    const dvec3 p = local.origin + shift * d;
    const Interval within{range.lo * length - shift, range.hi * length - shift};
    const auto emit = [&](const auto& roots) {
      for (std::size_t i = roots.count; i-- > 0;) sink((roots.t[i] + shift) / length, 0);
    };
    if (order_ == 2) return emit(solve_quadratic(expand<2>(p, d).c, within));
    if (!curved_) return;
    // The monotone stretches of cubics and quartics lose no root and invent none: `sturm` has nothing to add to them.
    if (order_ == 3) return emit(solve_cubic(expand<3>(p, d).c, within));
    if (order_ == 4) return emit(solve_quartic(expand<4>(p, d).c, within));
    const AlongRay<Poly::kMaxOrder> along = expand<Poly::kMaxOrder>(p, d);
    emit(certified_roots({along.c.data(), static_cast<std::size_t>(order_) + 1}, within));
  }

  Aabb bounds() const override { return Aabb::infinite(); }
  bool inside(const dvec3& point) const override { return value(to_world_->inverse_point(point)) < kInsideTolerance; }
  dvec3 normal(const ShapeHit&, const dvec3& point) const override {
    const dvec3 gradient = to_world_->normal(gradient_at(to_world_->inverse_point(point)));
    const double length = glm::length(gradient);
    return length > 0 ? gradient / length : dvec3(1, 0, 0);
  }
  bool tests_own_box() const override { return false; }
  bool prefers_clipped_range() const override { return order_ > 2; }

 private:
  // Horner's rule, x outermost; coefficients are met in the order they are kept in. Up to order 4 the order is the capacity and a
  // constant, so that the loops unroll. Most polynomials that people write have few terms: what is zero is stepped over.
  template <int Capacity>
  AlongRay<Capacity> expand(const dvec3& p, const dvec3& d) const {
    const int order = Capacity == Poly::kMaxOrder ? order_ : Capacity;
    const double* next = coefficients_.data();
    AlongRay<Capacity> fx, fy, fz;
    fx.c[0] = *next++;
    for (int nx = 1; nx <= order; ++nx) {
      if (!has_terms(nx)) {
        fx.multiply_add(nx - 1, p.x, d.x, 0);
        next += (nx + 1) * (nx + 2) / 2;
        continue;
      }
      fy.c[0] = *next++;
      for (int ny = 1; ny <= nx; ++ny) {
        if (!has_terms(nx, ny)) {
          fy.multiply_add(ny - 1, p.y, d.y, 0);
          next += ny + 1;
          continue;
        }
        fz.c[0] = *next++;
        for (int nz = 1; nz <= ny; ++nz) fz.multiply_add(nz - 1, p.z, d.z, *next++);
        fy.multiply_add(ny - 1, p.y, d.y, fz);
      }
      fx.multiply_add(nx - 1, p.x, d.x, fy);
    }
    return fx;
  }

  // Whether any term has the power order - nx of x; and then the power nx - ny of y.
  bool has_terms(int nx) const { return terms_of_x_[static_cast<std::size_t>(nx)]; }
  bool has_terms(int nx, int ny) const { return terms_of_y_[static_cast<std::size_t>(nx * (nx + 1) / 2 + ny)]; }

  void note_terms() {
    const double* next = coefficients_.data();
    for (int nx = 0; nx <= order_; ++nx) {
      bool any_in_x = false;
      for (int ny = 0; ny <= nx; ++ny, next += ny) {
        const bool any = std::any_of(next, next + ny + 1, [](double c) { return c != 0; });
        terms_of_y_.push_back(any);
        any_in_x |= any;
        for (int nz = 0; nz <= ny && nz < order_ - 1; ++nz) curved_ |= next[nz] != 0;  // the degree of the term is order - nz
      }
      terms_of_x_.push_back(any_in_x);
    }
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
  std::vector<char> terms_of_x_, terms_of_y_;
  bool curved_ = false;  // else a plane, which nothing above order 2 shows in the reference
  SharedTransform to_world_;
};

}  // namespace

std::unique_ptr<Shape> build(const Poly& poly, const SharedTransform& to_world, BuildContext&) {
  return std::make_unique<PolySurface>(poly, to_world);
}

}  // namespace lute
