// The one root of a polynomial between two values of opposite sign, by Halley's method inside its bracket.
//
// Each step triples the correct digits, and what it leaves is known: (second^2 - third first) / first^2 step^3, with the derivatives divided
// by the factorial of their order. The walk ends where that is below the last bit, so that no step is spent on seeing that nothing moves any
// more. Steps that leave the bracket are Newton's or halve it. Source: W. Gander, On Halley's Iteration Method, 1985.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace lute {

// A stretch with one change of sign, from the sign of f_lo, and where in it to look first.
struct Bracket {
  double lo, hi, f_lo, guess;
};

// A polynomial's value and its first three derivatives, each divided by the factorial of its order.
struct Taylor {
  double f, first, second, third;
};

// Horner's rule; ascending coefficients, `degree` at least 3. A constant of type std::integral_constant lets the compiler unroll.
template <class Degree>
inline Taylor expand(const double* c, Degree degree, double t) {
  double first = c[degree], f = first * t + c[degree - 1], second = first;
  first = first * t + f;
  f = f * t + c[degree - 2];
  double third = second;
  second = second * t + first;
  first = first * t + f;
  f = f * t + c[degree - 3];
  for (std::size_t i = degree - 3; i-- > 0;) {
    third = third * t + second;
    second = second * t + first;
    first = first * t + f;
    f = f * t + c[i];
  }
  return {f, first, second, third};
}

template <class Degree>
double bracketed_root(const double* c, Degree degree, const Bracket& bracket) {
  if (degree < 3) {  // a cubic without its highest terms
    std::array<double, 4> padded{};
    std::copy(c, c + degree + 1, padded.begin());
    return bracketed_root(padded.data(), std::integral_constant<std::size_t, 3>(), bracket);
  }
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  double lo = bracket.lo, hi = bracket.hi, t = bracket.guess;
  const bool rising = bracket.f_lo < 0;
  for (int step = 0; step < 200; ++step) {
    const Taylor v = expand(c, degree, t);
    if (v.f == 0) return t;
    ((v.f < 0) == rising ? lo : hi) = t;
    const double slope2 = v.first * v.first;
    double next = t - v.f * v.first / (slope2 - v.f * v.second);
    if (next > lo && next < hi) {
      const double moved = std::abs(next - t), size = std::abs(next);
      if (moved <= 1e-4 * size && std::abs(v.second) * moved <= 1e-3 * std::abs(v.first) &&
          std::abs(v.second * v.second - v.third * v.first) * (moved * moved * moved) <= 0.25 * kUlp * size * slope2)
        return next;
    } else {
      next = t - v.f / v.first;
      if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);  // also for a derivative of 0
    }
    if (std::abs(next - t) <= kUlp * std::abs(next) || next == lo || next == hi) return next;
    // Creeping along one side of a flat stretch: halve now and then.
    if (step % 16 == 15) next = 0.5 * (lo + hi);
    t = next;
  }
  return t;
}

}  // namespace lute
