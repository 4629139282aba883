// The roots of a polynomial of fixed degree in a range, one after the other from the front, for rays that need the first one only.
//
// Bernstein coefficients bound the number of roots by the changes of their signs (Descartes' rule): none or one ends the search of an interval, more
// divide it. Where signs are not clear, or after a few divisions (a grazing ray), the monotone stretches of engine/math/polynomial.hpp decide, so
// that nothing is lost that solve_polynomial would find. Source: J. M. Lane, R. F. Riesenfeld, Bounds on a Polynomial, 1981.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include "engine/math/bracketed_root.hpp"
#include "engine/math/polynomial.hpp"

namespace lute {

// Coefficients ascending, the range finite and not empty. visit(t) is called with ascending roots until it returns true; then true is returned.
// Unless kExact, t may be anywhere within the range where that has one root only.
template <std::size_t Degree, bool kExact, class Visit>
class RootWalk {
 public:
  using Coefficients = std::array<double, Degree + 1>;

  RootWalk(const Coefficients& c, Visit& visit) : c_(c), visit_(visit) {}

  bool walk(Interval range) {
    Coefficients b = c_;
    if (range.lo != 0)
      for (std::size_t i = 0; i < Degree; ++i)
        for (std::size_t j = Degree; j-- > i;) b[j] += range.lo * b[j + 1];
    const double width = range.hi - range.lo;
    double power = 1;
    for (std::size_t i = 1; i <= Degree; ++i) b[i] *= (power *= width) / kBinomial[i];
    double size = 0;
    for (const double v : b) size += std::abs(v);
    for (std::size_t i = 1; i <= Degree; ++i)
      for (std::size_t j = Degree; j >= i; --j) b[j] += b[j - 1];
    unclear_ = 4 * static_cast<double>(Degree) * std::numeric_limits<double>::epsilon() * size;
    return search(b, range.lo, range.hi, 0);
  }

 private:
  static constexpr Coefficients kBinomial = [] {
    Coefficients binomial{1};
    for (std::size_t i = 1; i <= Degree; ++i) binomial[i] = binomial[i - 1] * static_cast<double>(Degree - i + 1) / static_cast<double>(i);
    return binomial;
  }();

  bool search(const Coefficients& b, double lo, double hi, int depth) {
    int changes = 0;
    bool clear = std::abs(b[0]) > unclear_;
    for (std::size_t i = 1; i <= Degree; ++i) {
      clear &= std::abs(b[i]) > unclear_;
      changes += (b[i] < 0) != (b[i - 1] < 0);
    }
    if (clear && changes == 0) return false;
    if (clear && changes == 1) return visit_(kExact ? bracketed(lo, hi, b[0], b[Degree]) : 0.5 * (lo + hi));
    constexpr int kDeepest = 5;
    if (depth == kDeepest) {
      for (const double t : solve_polynomial(c_, {lo, hi})) {
        if (t <= last_) continue;  // a root at a border belongs to both sides
        last_ = t;
        if (visit_(t)) return true;
      }
      return false;
    }
    Coefficients left, right = b;
    for (std::size_t i = 0; i <= Degree; ++i) {
      left[i] = right[0];
      for (std::size_t j = 0; j + i < Degree; ++j) right[j] = 0.5 * (right[j] + right[j + 1]);
    }
    const double middle = 0.5 * (lo + hi);
    return search(left, lo, middle, depth + 1) || search(right, middle, hi, depth + 1);
  }

  // From where a straight line would have the root.
  double bracketed(double lo, double hi, double f_lo, double f_hi) const {
    const double guess = lo + (hi - lo) * (f_lo / (f_lo - f_hi));
    return bracketed_root(c_.data(), std::integral_constant<std::size_t, Degree>(), {lo, hi, f_lo, guess});
  }

  const Coefficients& c_;
  Visit& visit_;
  double unclear_ = 0;
  double last_ = -std::numeric_limits<double>::infinity();
};

template <bool kExact = true, std::size_t Terms, class Visit>
bool walk_roots(const std::array<double, Terms>& c, Interval range, Visit&& visit) {
  return RootWalk<Terms - 1, kExact, Visit>(c, visit).walk(range);
}

}  // namespace lute
