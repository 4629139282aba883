// spline { [type] t0, V0 t1, V1 ... }: piecewise curves through points of 2 to 5 components.
// Source: specification chapter 10 §10.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace lute {

struct Enclosure;

enum class SplineKind : std::uint8_t { kLinear, kQuadratic, kCubic, kNatural };

class Spline {
 public:
  using Point = std::array<double, 5>;

  SplineKind kind = SplineKind::kLinear;
  int components = 2;

  // Keeps the points sorted by `t`. An equal `t` replaces the value, except that one equal to the largest is ignored.
  void insert(double t, const Point& value);
  std::size_t size() const { return times_.size(); }

  Point evaluate(double t) const { return evaluate(t, kind); }
  Point evaluate(double t, SplineKind kind_for_this_call) const;
  // Bounds of one component and of its slope while t runs over a range (engine/function/enclosure.hpp).
  Enclosure enclose(const Enclosure& t, std::size_t component) const;

 private:
  // Component k between the points `segment` and `segment` + 1, for numbers and for ranges of numbers; m: second derivatives at the points.
  template <class T>
  T linear(std::size_t segment, const T& t, std::size_t k) const;
  template <class T>
  T quadratic(std::size_t segment, const T& t, std::size_t k) const;
  template <class T>
  T cubic(std::size_t segment, const T& t, std::size_t k) const;
  template <class T>
  T natural(std::size_t segment, const T& t, std::size_t k, const std::vector<double>& m) const;

  Point cubic(double t) const;
  std::size_t segment_of(double t) const;
  struct Tridiagonal {
    std::vector<double> u, w, m;
  };
  void find_second_derivatives(std::size_t k, Tridiagonal& system) const;  // into m

  std::vector<double> times_;
  std::vector<Point> values_;
};
using SplinePtr = std::shared_ptr<const Spline>;

}  // namespace lute
