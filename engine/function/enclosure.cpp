#include "engine/function/enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/math/vec.hpp"

namespace lute {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// More than the error of any operation and library function used here (one unit in the last place each).
double down(double v) { return std::isfinite(v) ? v - (std::abs(v) * 1e-15 + 1e-300) : v; }
double up(double v) { return std::isfinite(v) ? v + (std::abs(v) * 1e-15 + 1e-300) : v; }

struct Range {
  double lo, hi;
};

constexpr Range kAnything{-kInfinity, kInfinity};

// One number, computed as the program computes it: nothing to round outward. Counters of loops stay what they are.
bool is_number(Range a) { return a.lo == a.hi; }

// Rounded outward; what is not a number may be anything.
Range outward(double lo, double hi) {
  if (!(lo <= hi)) return kAnything;
  return {down(lo), up(hi)};
}

double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }  // 0 times unbounded is 0

Range multiply(Range a, Range b) {
  if (is_number(a) && is_number(b)) return {product(a.lo, b.lo), product(a.lo, b.lo)};
  const auto [lo, hi] = std::minmax({product(a.lo, b.lo), product(a.lo, b.hi), product(a.hi, b.lo), product(a.hi, b.hi)});
  return outward(lo, hi);
}
Range add(Range a, Range b) {
  const double lo = a.lo + b.lo, hi = a.hi + b.hi;
  if (is_number(a) && is_number(b) && !std::isnan(lo)) return {lo, lo};
  return {std::isnan(lo) ? -kInfinity : down(lo), std::isnan(hi) ? kInfinity : up(hi)};
}
Range negate(Range a) { return {-a.hi, -a.lo}; }
Range hull(Range a, Range b) { return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)}; }
bool contains(Range a, double v) { return a.lo <= v && v <= a.hi; }

Range value(const Enclosure& e) { return {e.lo, e.hi}; }
Range slope(const Enclosure& e) { return {e.slope_lo, e.slope_hi}; }
Enclosure make(Range value, Range slope) { return {value.lo, value.hi, slope.lo, slope.hi}; }

// Chain rule: a function with value `v` and derivative `d` over the range of a.
Enclosure chain(const Enclosure& a, Range v, Range d) {
  const bool constant = a.slope_lo == 0 && a.slope_hi == 0;
  return make(v, constant ? Range{0, 0} : multiply(d, slope(a)));
}

template <class F>
Range rising(const Enclosure& a, F f) {
  return outward(f(a.lo), f(a.hi));
}
template <class F>
Range falling(const Enclosure& a, F f) {
  return outward(f(a.hi), f(a.lo));
}

Range reciprocal(Range a) {
  if (contains(a, 0)) return kAnything;
  return outward(1 / a.hi, 1 / a.lo);
}
Range square(Range a) {
  const double lo = std::abs(a.lo), hi = std::abs(a.hi);
  return outward(contains(a, 0) ? 0 : std::min(lo * lo, hi * hi), std::max(lo * lo, hi * hi));
}
Range root(Range a) { return a.hi < 0 ? kAnything : outward(std::sqrt(std::max(a.lo, 0.0)), std::sqrt(a.hi)); }

// A wave with the values p and q at the ends of the range, which is 1 at `peak` and half a turn later -1, and again every turn.
Range wave(Range a, double p, double q, double peak) {
  if (!(std::abs(a.lo) < 1e9 && std::abs(a.hi) < 1e9) || a.hi - a.lo >= 2 * kPi) return {-1, 1};
  const auto holds = [&](double phase) { return std::floor((a.hi - phase) / (2 * kPi) + 1e-9) > std::ceil((a.lo - phase) / (2 * kPi) - 1e-9) - 0.5; };
  return {holds(peak + kPi) ? -1 : std::max(-1.0, down(std::min(p, q))), holds(peak) ? 1 : std::min(1.0, up(std::max(p, q)))};
}
Range cosine(Range a) { return wave(a, std::cos(a.lo), std::cos(a.hi), 0); }
Range sine(Range a) { return wave(a, std::sin(a.lo), std::sin(a.hi), kPi / 2); }

// A step function that rises: its value, and a slope of 0 if it is the same all over.
template <class F>
Enclosure steps(const Enclosure& a, F f) {
  const Enclosure result(f(a.lo), f(a.hi), 0, 0);
  return result.lo == result.hi ? result : result.jumping();
}

Enclosure decided(bool certainly, bool certainly_not) {
  if (certainly) return 1;
  if (certainly_not) return 0;
  return Enclosure(0, 1, 0, 0).jumping();
}

Enclosure integer_power(const Enclosure& a, double n) {
  if (n == 0) return 1;
  if (n < 0) return Enclosure(1) / integer_power(a, -n);
  const bool even = std::fmod(n, 2) == 0;
  const double p = std::pow(a.lo, n), q = std::pow(a.hi, n);
  const Range v = even && contains(value(a), 0) ? outward(0, std::max(p, q)) : outward(std::min(p, q), std::max(p, q));
  const double r = n * std::pow(a.lo, n - 1), s = n * std::pow(a.hi, n - 1);
  const Range d = !even && contains(value(a), 0) ? outward(0, std::max(r, s)) : outward(std::min(r, s), std::max(r, s));
  Enclosure result = chain(a, v, d);
  if (n == 2) result.root_steepest = a.steepest();
  return result;
}

}  // namespace

Enclosure Enclosure::unknown() { return {-kInfinity, kInfinity, -kInfinity, kInfinity}; }
Enclosure Enclosure::jumping() const { return {lo, hi, -kInfinity, kInfinity}; }
double Enclosure::steepest() const { return std::max(std::abs(slope_lo), std::abs(slope_hi)); }

Enclosure operator-(const Enclosure& a) { return make(negate(value(a)), negate(slope(a))); }
Enclosure operator+(const Enclosure& a, const Enclosure& b) {
  Enclosure sum = make(add(value(a), value(b)), add(slope(a), slope(b)));
  const double r = a.root_steepest, s = b.root_steepest;
  sum.root_steepest = r == 0 ? s : s == 0 ? r : up(std::sqrt(r * r + s * s));
  return sum;
}
Enclosure operator-(const Enclosure& a, const Enclosure& b) { return a + (-b); }
Enclosure operator*(const Enclosure& a, const Enclosure& b) {
  if (&a == &b) {  // a square: the same number twice
    Enclosure result = chain(a, square(value(a)), multiply({2, 2}, value(a)));
    result.root_steepest = a.steepest();
    return result;
  }
  Enclosure result = make(multiply(value(a), value(b)), add(multiply(slope(a), value(b)), multiply(value(a), slope(b))));
  if (a.is_constant() && a.lo > 0) result.root_steepest = up(std::sqrt(a.lo) * b.root_steepest);
  if (b.is_constant() && b.lo > 0) result.root_steepest = up(std::sqrt(b.lo) * a.root_steepest);
  return result;
}
Enclosure operator/(const Enclosure& a, const Enclosure& b) {
  const Range inverse = reciprocal(value(b));
  return a * chain(b, inverse, negate(square(inverse)));
}

Enclosure sqrt(const Enclosure& a) {
  const Range v = root(value(a));
  Enclosure result = chain(a, v, multiply({0.5, 0.5}, reciprocal({std::max(v.lo, 0.0), v.hi})));
  result.slope_lo = std::max(result.slope_lo, -a.root_steepest);
  result.slope_hi = std::min(result.slope_hi, a.root_steepest);
  return result;
}
Enclosure exp(const Enclosure& a) {
  const Range v = rising(a, [](double x) { return std::exp(x); });
  return chain(a, {std::max(v.lo, 0.0), v.hi}, {std::max(v.lo, 0.0), v.hi});
}
Enclosure sin(const Enclosure& a) { return chain(a, sine(value(a)), cosine(value(a))); }
Enclosure cos(const Enclosure& a) { return chain(a, cosine(value(a)), negate(sine(value(a)))); }
Enclosure fabs(const Enclosure& a) {
  if (a.lo >= 0) return a;
  if (a.hi <= 0) return -a;
  return make({0, std::max(-a.lo, a.hi)}, hull(slope(a), negate(slope(a))));
}
Enclosure min(const Enclosure& a, const Enclosure& b) {
  if (a.hi < b.lo) return a;
  if (b.hi < a.lo) return b;
  return make({std::min(a.lo, b.lo), std::min(a.hi, b.hi)}, hull(slope(a), slope(b)));
}
Enclosure max(const Enclosure& a, const Enclosure& b) { return -min(-a, -b); }
Enclosure pow(const Enclosure& a, const Enclosure& b) {
  if (!b.is_point()) {
    if (!(a.lo > 0)) return Enclosure::unknown();
    return exp(b * enclose(UnaryOp::kLn, a));
  }
  const double n = b.lo;
  if (n == std::floor(n) && std::abs(n) <= 64) return integer_power(a, n);
  if (a.lo < 0) return Enclosure::unknown();
  const auto power = [n](double x) { return std::pow(x, n); };
  const Range v = n > 0 ? rising(a, power) : falling(a, power);
  const auto derivative = [n](double x) { return n * std::pow(x, n - 1); };
  const Range d = n > 1 || n < 0 ? rising(a, derivative) : falling(a, derivative);
  return chain(a, {std::max(v.lo, 0.0), v.hi}, d);
}
Enclosure atan2(const Enclosure& y, const Enclosure& x) {
  // The cut is the negative x axis; the origin belongs to it.
  if (x.lo <= 0 && contains(value(y), 0)) return Enclosure(down(-kPi), up(kPi), 0, 0).jumping();
  const auto [lo, hi] = std::minmax({std::atan2(y.lo, x.lo), std::atan2(y.lo, x.hi), std::atan2(y.hi, x.lo), std::atan2(y.hi, x.hi)});
  const Range numerator = add(multiply(value(x), slope(y)), negate(multiply(value(y), slope(x))));
  return make(outward(lo, hi), multiply(numerator, reciprocal(add(square(value(x)), square(value(y))))));
}

Enclosure either(const Enclosure& a, const Enclosure& b) {
  const Range v = hull(value(a), value(b));
  return Enclosure(v.lo, v.hi, 0, 0).jumping();
}

Enclosure enclose(UnaryOp op, const Enclosure& a) {
  if (a.is_constant()) return apply(op, a.lo);
  const Range v = value(a);
  const auto in = [&](double lo, double hi) { return a.lo >= lo && a.hi <= hi; };
  switch (op) {
    case UnaryOp::kNegate: return -a;
    case UnaryOp::kSin: return sin(a);
    case UnaryOp::kCos: return cos(a);
    case UnaryOp::kTan: return sin(a) / cos(a);
    case UnaryOp::kAsin:
      if (!in(-1, 1)) return Enclosure::unknown();
      return chain(a, rising(a, [](double x) { return std::asin(x); }), reciprocal(root(add({1, 1}, negate(square(v))))));
    case UnaryOp::kAcos:
      if (!in(-1, 1)) return Enclosure::unknown();
      return chain(a, falling(a, [](double x) { return std::acos(x); }), negate(reciprocal(root(add({1, 1}, negate(square(v)))))));
    case UnaryOp::kAtan: return chain(a, rising(a, [](double x) { return std::atan(x); }), reciprocal(add({1, 1}, square(v))));
    case UnaryOp::kSinh: return (exp(a) - exp(-a)) * 0.5;
    case UnaryOp::kCosh: return (exp(a) + exp(-a)) * 0.5;
    case UnaryOp::kTanh: {
      const Range t = rising(a, [](double x) { return std::tanh(x); });
      return chain(a, t, add({1, 1}, negate(square(t))));
    }
    case UnaryOp::kAsinh:
      return chain(a, rising(a, [](double x) { return std::asinh(x); }), reciprocal(root(add({1, 1}, square(v)))));
    case UnaryOp::kAcosh:
      if (!in(1, kInfinity)) return Enclosure::unknown();
      return chain(a, rising(a, [](double x) { return std::acosh(x); }), reciprocal(root(add(square(v), {-1, -1}))));
    case UnaryOp::kAtanh:
      if (!in(-1, 1)) return Enclosure::unknown();
      return chain(a, rising(a, [](double x) { return std::atanh(x); }), reciprocal(add({1, 1}, negate(square(v)))));
    case UnaryOp::kAbs: return fabs(a);
    case UnaryOp::kRadians: return a * (kPi / 180.0);
    case UnaryOp::kDegrees: return a * (180.0 / kPi);
    case UnaryOp::kFloor: return steps(a, [](double x) { return std::floor(x); });
    case UnaryOp::kCeil: return steps(a, [](double x) { return std::ceil(x); });
    case UnaryOp::kInt:
      if (!in(-2147483648.0, 2147483647.0)) return Enclosure::unknown();
      return steps(a, [](double x) { return std::trunc(x); });
    case UnaryOp::kSqrt: return a.lo < 0 && !std::isfinite(a.root_steepest) ? Enclosure::unknown() : sqrt(a);
    case UnaryOp::kExp: return exp(a);
    case UnaryOp::kLn:
      if (!(a.lo > 0)) return Enclosure::unknown();
      return chain(a, rising(a, [](double x) { return std::log(x); }), reciprocal(v));
    case UnaryOp::kLog:
      if (!(a.lo > 0)) return Enclosure::unknown();
      return chain(a, rising(a, [](double x) { return std::log10(x); }), multiply({1 / std::log(10.0), 1 / std::log(10.0)}, reciprocal(v)));
  }
  return Enclosure::unknown();
}

Enclosure enclose(BinaryOp op, const Enclosure& a, const Enclosure& b) {
  if (a.is_constant() && b.is_constant()) return apply(op, a.lo, b.lo);
  const bool apart = a.hi < b.lo || b.hi < a.lo;
  const bool same_point = a.is_point() && b.is_point() && a.lo == b.lo;
  const auto is_zero = [](const Enclosure& e) { return e.lo == 0 && e.hi == 0; };
  const auto not_zero = [](const Enclosure& e) { return e.lo > 0 || e.hi < 0; };
  switch (op) {
    case BinaryOp::kAdd: return a + b;
    case BinaryOp::kSubtract: return a - b;
    case BinaryOp::kMultiply: return a * b;
    case BinaryOp::kDivide: return a / b;
    case BinaryOp::kLess: return decided(a.hi < b.lo, a.lo >= b.hi);
    case BinaryOp::kLessEqual: return decided(a.hi <= b.lo, a.lo > b.hi);
    case BinaryOp::kGreater: return decided(a.lo > b.hi, a.hi <= b.lo);
    case BinaryOp::kGreaterEqual: return decided(a.lo >= b.hi, a.hi < b.lo);
    case BinaryOp::kEqual: return decided(same_point, apart);
    case BinaryOp::kNotEqual: return decided(apart, same_point);
    case BinaryOp::kAnd: return decided(not_zero(a) && not_zero(b), is_zero(a) || is_zero(b));
    case BinaryOp::kOr: return decided(not_zero(a) || not_zero(b), is_zero(a) && is_zero(b));
    case BinaryOp::kAtan2: return atan2(a, b);
    case BinaryOp::kMod: {
      if (!b.is_point() || b.lo == 0 || !std::isfinite(a.lo) || !std::isfinite(a.hi)) return Enclosure::unknown();
      const double period = std::abs(b.lo), turns = std::trunc(a.lo / period);
      // Within one period, and away from its ends by more than rounding.
      if (turns == std::trunc(a.hi / period) && std::abs(turns) < 1e9) {
        const double slack = 1e-15 * std::max(std::abs(a.lo), std::abs(a.hi));  // of the product, which cancels
        const Enclosure rest = a - turns * period + Enclosure(-slack, slack, 0, 0);
        if (rest.lo > -period && rest.hi < period) return rest;
      }
      return Enclosure(a.lo < 0 ? -period : 0, a.hi > 0 ? period : 0, 0, 0).jumping();
    }
    case BinaryOp::kPow: return pow(a, b);
    case BinaryOp::kDiv: {
      const Enclosure quotient = a / b;
      if (!(quotient.lo > -2147483648.0 && quotient.hi < 2147483647.0)) return Enclosure::unknown();
      return steps(quotient, [](double x) { return std::trunc(x); });
    }
    case BinaryOp::kMin: return min(a, b);
    case BinaryOp::kMax: return max(a, b);
  }
  return Enclosure::unknown();
}

}  // namespace lute
