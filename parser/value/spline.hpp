// spline { [type] t0, V0 t1, V1 ... }: piecewise curves through points of 2 to 5 components.
// Source: specification chapter 10 §10.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace lute {

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

 private:
  Point linear(std::size_t segment, double t) const;
  Point quadratic(std::size_t segment, double t) const;
  Point cubic(double t) const;
  Point natural(std::size_t segment, double t) const;

  std::vector<double> times_;
  std::vector<Point> values_;
};
using SplinePtr = std::shared_ptr<const Spline>;

}  // namespace lute
