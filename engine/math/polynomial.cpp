#include "engine/math/polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "engine/math/bracketed_root.hpp"

namespace lute {

namespace {

constexpr double kUlp = std::numeric_limits<double>::epsilon();

struct Value {
  double f, derivative;
};

// Horner's rule; `degree` at least 1.
template <class Degree>
inline Value evaluate(const double* c, Degree degree, double t) {
  double derivative = c[degree];
  double f = derivative * t + c[degree - 1];
  for (std::size_t i = degree - 1; i-- > 0;) {
    derivative = derivative * t + f;
    f = f * t + c[i];
  }
  return {f, derivative};
}

// The value, or exactly 0 where it cannot be told from 0: below the rounding error of its own evaluation.
template <class Degree>
inline double significant_value(const double* c, Degree degree, double t) {
  double f = c[degree];
  double size = std::abs(f);
  const double abs_t = std::abs(t);
  for (std::size_t i = degree; i-- > 0;) {
    f = f * t + c[i];
    size = size * abs_t + std::abs(c[i]);
  }
  return std::abs(f) <= 2 * kUlp * static_cast<double>(degree) * size ? 0 : f;
}

// Roots of c0 + c1 t in range.
std::size_t linear_roots(const double* c, Interval range, double* out) {
  const double t = -c[0] / c[1];
  if (!range.contains(t)) return 0;
  out[0] = t;
  return 1;
}

std::size_t quadratic_roots(const double* c, Interval range, double* out) {
  if (c[2] == 0) return linear_roots(c, range, out);
  const double half_b = 0.5 * c[1];
  double discriminant = half_b * half_b - c[2] * c[0];
  if (std::abs(discriminant) <= 2 * kUlp * half_b * half_b) discriminant = 0;
  if (!(discriminant >= 0)) return 0;
  std::size_t count = 0;
  if (discriminant == 0) {
    const double t = -half_b / c[2];
    if (range.contains(t)) out[count++] = t;
    return count;
  }
  const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
  double first = q / c[2];
  double second = q == 0 ? 0 : c[0] / q;
  if (second < first) std::swap(first, second);
  if (range.contains(first)) out[count++] = first;
  if (range.contains(second)) out[count++] = second;
  return count;
}

// Shortens a long bracket that begins at an inner point (where the derivative is 0, or the beginning of a range) and ends far out:
// steps of growing length from the inner point. The first is the root of the parabola, or the line, that fits there. Without this,
// Newton's method comes in from afar by a constant factor a step.
template <class Degree>
Bracket shorten_from(const double* c, Degree degree, double inner, double outer, double f_inner) {
  double second = 0, first = 0, f = c[degree];
  for (std::size_t i = degree; i-- > 0;) {
    second = second * inner + first;
    first = first * inner + f;
    f = f * inner + c[i];
  }
  // f + first h + second h^2, with h of the sign of outer - inner.
  double step = std::sqrt(std::abs(f_inner / second));
  const double straight = std::abs(f_inner / first);
  if (straight < step) step = straight;
  const double whole = std::abs(outer - inner);
  step = std::max(step, 1e-12 * whole);
  const double direction = outer > inner ? 1 : -1;
  double reached = inner, f_reached = f_inner, end = outer;
  for (double span = 1.25 * step; span < 0.5 * whole; span *= 4) {
    const double t = inner + direction * span;
    const double f_t = evaluate(c, degree, t).f;
    if ((f_t < 0) != (f_inner < 0)) {
      end = t;
      break;
    }
    reached = t;
    f_reached = f_t;
  }
  double guess = inner + direction * step;
  if (direction > 0) {
    if (!(guess > reached && guess < end)) guess = 0.5 * (reached + end);
    return {reached, end, f_reached, guess};
  }
  if (!(guess < reached && guess > end)) guess = 0.5 * (reached + end);
  return {end, reached, -f_reached, guess};
}

// The roots of a polynomial in range, from the points that split the range into monotone stretches.
template <class Degree>
std::size_t roots_between(const double* c, Degree degree, Interval range, const double* splits, std::size_t split_count,
                          double* out) {
  std::size_t count = 0;
  const auto add = [&](double t) {
    if (count == 0 || out[count - 1] < t) out[count++] = t;
  };
  double lo = range.lo;
  double f_lo = evaluate(c, degree, lo).f;
  if (f_lo == 0) add(lo);
  for (std::size_t i = 0; i <= split_count; ++i) {
    const bool last = i == split_count;
    const double hi = last ? range.hi : splits[i];
    if (!(hi > lo)) continue;
    const double f_hi = last ? evaluate(c, degree, hi).f : significant_value(c, degree, hi);
    if ((f_lo < 0 && f_hi > 0) || (f_lo > 0 && f_hi < 0)) {
      Bracket bracket{lo, hi, f_lo, 0.5 * (lo + hi)};
      if (last) {
        bracket = shorten_from(c, degree, lo, hi, f_lo);
      } else if (i == 0) {
        bracket = shorten_from(c, degree, hi, lo, f_hi);
      }
      add(bracketed_root(c, degree, bracket));
    }
    if (f_hi == 0) add(hi);
    lo = hi;
    f_lo = f_hi;
  }
  return std::min<std::size_t>(count, degree);
}

template <std::size_t N>
using Fixed = std::integral_constant<std::size_t, N>;

// Fixed degree, so that the compiler can unroll: each degree asks the one below for its derivative's roots.
template <std::size_t Degree>
std::size_t fixed_roots(const double* c, Interval range, double* out) {
  if constexpr (Degree == 2) {
    return quadratic_roots(c, range, out);
  } else {
    if (c[Degree] == 0) return fixed_roots<Degree - 1>(c, range, out);
    double derivative[Degree];
    for (std::size_t i = 0; i < Degree; ++i) derivative[i] = static_cast<double>(i + 1) * c[i + 1];
    double splits[Degree + 1];
    const std::size_t split_count = fixed_roots<Degree - 1>(derivative, range, splits);
    return roots_between(c, Fixed<Degree>(), range, splits, split_count, out);
  }
}

// The real roots of a cubic in range, ascending, to ten digits or better: the closed form (Cardano, and Viete's cosines) where its
// discriminant is far from 0. Where roots meet, also when they only seem to beside a third that is far away, it would lose digits
// and roots. Good enough to split a quartic: there its slope is 0, so that an error counts by its square.
std::size_t cubic_splits(const double* c, Interval range, double* out) {
  const double b = c[2] / (3 * c[3]);
  const double p = c[1] / (3 * c[3]) - b * b;
  const double q = b * b * b + 0.5 * (c[0] - b * c[1]) / c[3];
  const double discriminant = q * q + p * p * p;
  constexpr double kFarFromZero = 1e-10;
  if (!(std::abs(discriminant) > kFarFromZero * q * q)) return fixed_roots<3>(c, range, out);
  std::array<double, 3> t;
  std::size_t found = 0;
  if (discriminant > 0) {
    const double u = std::cbrt(std::abs(q) + std::sqrt(discriminant));
    t[found++] = -std::copysign(u - p / u, q) - b;
  } else {
    const double root = std::sqrt(-p);
    const double angle = std::acos(std::clamp(q / (p * root), -1.0, 1.0)) / 3;
    // cos(angle -+ 120 degrees) from one cosine and one sine.
    const double cosine = root * std::cos(angle), sine = root * std::sqrt(3.0) * std::sin(angle);
    t = {-cosine - sine - b, -cosine + sine - b, 2 * cosine - b};
    found = 3;
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < found; ++i)
    if (range.contains(t[i])) out[count++] = t[i];
  return count;
}

std::size_t quartic_roots(const double* c, Interval range, double* out) {
  if (c[4] == 0) return fixed_roots<3>(c, range, out);
  const double derivative[4] = {c[1], 2 * c[2], 3 * c[3], 4 * c[4]};
  double splits[4];
  const std::size_t split_count = cubic_splits(derivative, range, splits);
  return roots_between(c, Fixed<4>(), range, splits, split_count, out);
}

// A finite part of the range that has all roots.
template <std::size_t Count>
Interval finite_part(const std::array<double, Count>& c, Interval range) {
  if (std::isfinite(range.lo) && std::isfinite(range.hi)) return range;
  const double bound = root_bound(c);
  return {std::max(range.lo, -bound), std::min(range.hi, bound)};
}

}  // namespace

Roots<2> solve_quadratic(const std::array<double, 3>& c, Interval range) {
  Roots<2> roots;
  roots.count = quadratic_roots(c.data(), range, roots.t.data());
  return roots;
}

Roots<3> solve_cubic(const std::array<double, 4>& c, Interval range) {
  std::array<double, 5> t;
  range = finite_part(c, range);
  Roots<3> roots;
  if (range.empty()) return roots;
  roots.count = std::min<std::size_t>(3, fixed_roots<3>(c.data(), range, t.data()));
  std::copy_n(t.begin(), roots.count, roots.t.begin());
  return roots;
}

Roots<4> solve_quartic(const std::array<double, 5>& c, Interval range) {
  std::array<double, 6> t;
  range = finite_part(c, range);
  Roots<4> roots;
  if (range.empty()) return roots;
  roots.count = std::min<std::size_t>(4, quartic_roots(c.data(), range, t.data()));
  std::copy_n(t.begin(), roots.count, roots.t.begin());
  return roots;
}

Roots<kMaxPolynomialDegree> solve_polynomial(std::span<const double> c, Interval range) {
  Roots<kMaxPolynomialDegree> roots;
  while (!c.empty() && c.back() == 0) c = c.first(c.size() - 1);
  if (c.size() < 2) return roots;
  if (c.size() == 2) {
    roots.count = linear_roots(c.data(), range, roots.t.data());
    return roots;
  }
  const std::size_t degree = c.size() - 1;
  const double bound = root_bound(c);
  range = {std::max(range.lo, -bound), std::min(range.hi, bound)};
  if (range.empty()) return roots;

  // derivatives[k] is the k-th derivative, of degree `degree - k`, up to a factor.
  double derivatives[kMaxPolynomialDegree][kMaxPolynomialDegree + 1];
  std::copy(c.begin(), c.end(), derivatives[0]);
  for (std::size_t k = 1; k + 2 <= degree; ++k)
    for (std::size_t i = 0; i + k <= degree; ++i)
      derivatives[k][i] = derivatives[k - 1][i + 1] * static_cast<double>(i + 1) / static_cast<double>(degree - k + 1);

  double splits[kMaxPolynomialDegree + 2];
  double found[kMaxPolynomialDegree + 2];
  std::size_t count = quadratic_roots(derivatives[degree - 2], range, found);
  for (std::size_t d = 3; d <= degree; ++d) {
    std::copy_n(found, count, splits);
    count = roots_between(derivatives[degree - d], d, range, splits, count, found);
  }
  roots.count = count;
  std::copy_n(found, count, roots.t.begin());
  return roots;
}

bool may_have_root(std::span<const double> c, Interval range) {
  const std::size_t degree = c.size() - 1;
  double b[kMaxPolynomialDegree + 1];
  // Taylor coefficients about lo, in units of the length of the range.
  std::copy(c.begin(), c.end(), b);
  for (std::size_t i = 0; i < degree; ++i)
    for (std::size_t j = degree; j-- > i;) b[j] += range.lo * b[j + 1];
  double power = 1;
  for (std::size_t i = 0; i <= degree; ++i, power *= range.hi - range.lo) b[i] *= power;
  // Monomial to Bernstein basis: divide by the binomials, then sum up.
  double binomial = 1;
  for (std::size_t i = 0; i <= degree; ++i) {
    b[i] /= binomial;
    binomial = binomial * static_cast<double>(degree - i) / static_cast<double>(i + 1);
  }
  for (std::size_t i = 1; i <= degree; ++i)
    for (std::size_t j = degree; j >= i; --j) b[j] += b[j - 1];
  const auto [low, high] = std::minmax_element(b, b + degree + 1);
  return *low < 0 && *high > 0;
}

Interval cubic_value_range(const std::array<double, 4>& c, Interval range) {
  const auto f = [&](double t) { return ((c[3] * t + c[2]) * t + c[1]) * t + c[0]; };
  Interval values{std::min(f(range.lo), f(range.hi)), std::max(f(range.lo), f(range.hi))};
  for (const double t : solve_quadratic({c[1], 2 * c[2], 3 * c[3]}, range))
    values = {std::min(values.lo, f(t)), std::max(values.hi, f(t))};
  return values;
}

double root_bound(std::span<const double> c) {
  const std::size_t degree = c.size() - 1;
  if (degree < 1 || c[degree] == 0) {
    return c.size() > 1 ? root_bound(c.first(degree)) : std::numeric_limits<double>::infinity();
  }
  double bound = 0;
  for (std::size_t i = 0; i < degree; ++i) {
    const double ratio = std::abs(c[i] / c[degree]);
    if (ratio == 0) continue;
    bound = std::max(bound, degree - i == 1 ? ratio : std::pow(ratio, 1.0 / static_cast<double>(degree - i)));
  }
  return 2 * bound * (1 + 1e-9);
}

}  // namespace lute
