// Interval arithmetic with slopes: what a value may be while a parameter runs over a stretch, and how fast it may change. An isosurface proves with it
// that a stretch of a ray meets no surface. Bounds are rounded outward, so that they hold for the numbers that the program computes.
// Where nothing is known the bounds are infinite; where the value may jump (floor, a decided comparison) the slope is unbounded.
// Source: R. E. Moore, R. B. Kearfott, M. J. Cloud, Introduction to Interval Analysis, 2009, chapters 5 and 6.
#pragma once

#include <limits>

#include "engine/function/program.hpp"

namespace lute {

struct Enclosure {
  double lo = 0, hi = 0;              // of the value
  double slope_lo = 0, slope_hi = 0;  // of its derivative by the parameter; of a function with kinks, of all difference quotients

  // Of a sum of squares: how steep its root may be. sqrt(x² + y²) is nowhere steeper than (x, y), which the slope of the sum does not tell
  // where both come near 0. Infinite: not known to be such a sum.
  double root_steepest = std::numeric_limits<double>::infinity();

  Enclosure() = default;
  Enclosure(double value) : lo(value), hi(value) {  // a constant; converts, so that formulas may be written as for numbers
    if (value >= 0) root_steepest = 0;
  }
  Enclosure(double low, double high, double slope_low, double slope_high) : lo(low), hi(high), slope_lo(slope_low), slope_hi(slope_high) {}

  static Enclosure unknown();
  // The same value, which may jump.
  Enclosure jumping() const;
  bool is_point() const { return lo == hi; }
  bool is_constant() const { return lo == hi && slope_lo == 0 && slope_hi == 0; }
  double steepest() const;  // the largest |slope|
};

Enclosure operator-(const Enclosure& a);
Enclosure operator+(const Enclosure& a, const Enclosure& b);
Enclosure operator-(const Enclosure& a, const Enclosure& b);
Enclosure operator*(const Enclosure& a, const Enclosure& b);
Enclosure operator/(const Enclosure& a, const Enclosure& b);

// The names that formulas use; each takes the whole of its argument's range.
Enclosure sqrt(const Enclosure& a);
Enclosure exp(const Enclosure& a);
Enclosure sin(const Enclosure& a);
Enclosure cos(const Enclosure& a);
Enclosure fabs(const Enclosure& a);
Enclosure min(const Enclosure& a, const Enclosure& b);
Enclosure max(const Enclosure& a, const Enclosure& b);
Enclosure pow(const Enclosure& a, const Enclosure& b);
Enclosure atan2(const Enclosure& y, const Enclosure& x);

Enclosure enclose(UnaryOp op, const Enclosure& a);
Enclosure enclose(BinaryOp op, const Enclosure& a, const Enclosure& b);

// Both: what a value may be that is one or the other. The values may differ, so the slope is unbounded.
Enclosure either(const Enclosure& a, const Enclosure& b);

}  // namespace lute
