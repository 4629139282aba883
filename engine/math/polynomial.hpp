// Real roots of polynomials in an interval.
//
// Coefficients are ascending: c[0] + c[1] t + c[2] t² + ... Roots come out ascending, each once: a double root (a grazing ray) is
// one root, and it is kept even if rounding has moved the polynomial off the axis there.
//
// Degrees 1 and 2 are closed forms without cancellation. Above, the roots of the derivative split the interval into stretches on
// which the polynomial is monotone, so that each stretch has a root exactly if the signs at its ends differ; it is found by
// Newton's method kept inside its bracket (C. Yuksel, High-Performance Polynomial Root Finding for Graphics, 2022). The two outer
// stretches, which may be as long as a scene, are cut down first by steps of growing length from their inner end. Nothing is
// lost or invented at triple roots, tangents or badly scaled coefficients, where the closed cubic and quartic (specification
// chapter 20 §4) lose digits; elsewhere the results agree.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "engine/math/interval.hpp"

namespace lute {

// At most N roots, in place.
template <std::size_t N>
struct Roots {
  std::array<double, N> t;
  std::size_t count = 0;

  void add(double root) { t[count++] = root; }
  const double* begin() const { return t.data(); }
  const double* end() const { return t.data() + count; }
};

Roots<2> solve_quadratic(const std::array<double, 3>& c, Interval range);
Roots<3> solve_cubic(const std::array<double, 4>& c, Interval range);
Roots<4> solve_quartic(const std::array<double, 5>& c, Interval range);

inline constexpr std::size_t kMaxPolynomialDegree = 35;

// Any degree up to kMaxPolynomialDegree; leading zeros are allowed.
Roots<kMaxPolynomialDegree> solve_polynomial(std::span<const double> c, Interval range);

// False only if the polynomial certainly has no root in the (finite) range: all its Bernstein coefficients have one sign. Zero
// belongs to both signs, so that a root at an end may be reported missing; callers that keep ends widen the range.
bool may_have_root(std::span<const double> c, Interval range);

// The least and the greatest value of a cubic over a finite range.
Interval cubic_value_range(const std::array<double, 4>& c, Interval range);

// A bound B so that every real root lies in [-B, B] (Fujiwara). Infinite for a constant.
double root_bound(std::span<const double> c);

}  // namespace lute
