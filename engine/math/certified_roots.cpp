#include "engine/math/certified_roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lute {

namespace {

constexpr double kRounding = std::numeric_limits<double>::epsilon() / 2;
constexpr std::size_t kMaxTerms = kMaxPolynomialDegree + 1;

// Not the middle: roots of scenes like to lie at binary fractions, and a root at the border of two halves takes both of them long.
constexpr double kShare = 0.4843;

// A coefficient and a bound of its error.
struct Bounded {
  double value = 0, error = 0;

  int sign() const { return value > error ? 1 : value < -error ? -1 : 0; }
};

// (1 - share) a + share b; the factors are exact enough to be counted as two roundings each.
Bounded between(const Bounded& a, const Bounded& b, double share) {
  const double value = (1 - share) * a.value + share * b.value;
  const double size = (1 - share) * std::abs(a.value) + share * std::abs(b.value);
  return {value, ((1 - share) * a.error + share * b.error + 4 * kRounding * size) * (1 + 8 * kRounding)};
}

using Terms = std::array<Bounded, kMaxTerms>;

// Bernstein coefficients over an interval: a Taylor shift to its beginning, in units of its length, then sums of divided terms.
Terms bernstein(std::span<const double> c, Interval over) {
  const std::size_t degree = c.size() - 1;
  Terms b;
  for (std::size_t i = 0; i <= degree; ++i) b[i] = {c[i], 0};
  const auto add = [](Bounded& to, const Bounded& from, double factor) {
    const double product = factor * from.value;
    const double value = to.value + product;
    to.error = (to.error + std::abs(factor) * from.error + kRounding * (std::abs(product) + std::abs(value))) * (1 + 8 * kRounding);
    to.value = value;
  };
  for (std::size_t i = 0; i < degree; ++i)
    for (std::size_t j = degree; j-- > i;) add(b[j], b[j + 1], over.lo);
  double power = 1;
  double binomial = 1;
  for (std::size_t i = 0; i <= degree; ++i) {
    const double factor = power / binomial;
    b[i].value *= factor;
    b[i].error = (b[i].error * factor + (2 * static_cast<double>(i) + 6) * kRounding * std::abs(b[i].value)) * (1 + 8 * kRounding);
    power *= over.hi - over.lo;
    binomial = binomial * static_cast<double>(degree - i) / static_cast<double>(i + 1);
  }
  for (std::size_t i = 1; i <= degree; ++i)
    for (std::size_t j = degree; j >= i; --j) add(b[j], b[j - 1], 1);
  return b;
}

struct Signs {
  bool certain = true;  // all of them
  bool any = false;     // at least one, by a margin that is worth a division
  int changes = 0;
};

// A coefficient this many times its error is clear. Less clear ones make a cluster: dividing them on and on tells nothing new.
constexpr double kClear = 16;

Signs signs_of(const Terms& b, std::size_t degree) {
  Signs signs;
  int last = 0;
  for (std::size_t i = 0; i <= degree; ++i) {
    const int sign = b[i].sign();
    if (sign == 0) {
      signs.certain = false;
      continue;
    }
    signs.any |= std::abs(b[i].value) > kClear * b[i].error;
    if (last != 0 && sign != last) ++signs.changes;
    last = sign;
  }
  return signs;
}

class Isolation {
 public:
  Isolation(std::span<const double> c, Interval range) : c_(c), degree_(c.size() - 1), range_(range) {}

  Roots<kMaxPolynomialDegree> roots() {
    divide(range_.lo, range_.hi, bernstein(c_, range_), 0);
    close_cluster();
    return found_;
  }

 private:
  void divide(double lo, double hi, const Terms& parents, int depth) {
    if (found_.count == degree_) return;
    Terms b = parents;
    Signs signs = signs_of(b, degree_);
    if (!signs.any) {  // errors were inherited from a wider interval: begin anew
      b = bernstein(c_, {lo, hi});
      signs = signs_of(b, degree_);
    }
    if (signs.certain && signs.changes == 0) return close_cluster();
    if (signs.certain && signs.changes == 1) {
      close_cluster();
      if (const double root = bracketed(c_, lo, hi); root > covered_) add_root(root);
      return;
    }
    constexpr int kDeepest = 120;
    const double split = lo + kShare * (hi - lo);
    if (!signs.any || depth == kDeepest || !(split > lo && split < hi)) return extend_cluster(lo, hi);
    Terms left, right = b;
    for (std::size_t i = 0; i <= degree_; ++i) {
      left[i] = right[0];
      for (std::size_t j = 0; j + i < degree_; ++j) right[j] = between(right[j], right[j + 1], kShare);
    }
    // After the sweep right[j] belongs to the second part, from its beginning.
    divide(lo, split, left, depth + 1);
    divide(split, hi, right, depth + 1);
  }

  // ---- clusters: neighbouring intervals over which the polynomial cannot be told from zero ----

  void extend_cluster(double lo, double hi) {
    if (cluster_.empty()) cluster_ = {lo, hi};
    cluster_.hi = hi;
  }

  // The roots of a cluster count as one, if there are any: where the sign changes from one side to the other, or where the polynomial has an
  // extremum that cannot be told from zero.
  void close_cluster() {
    if (cluster_.empty()) return;
    const Interval cluster = cluster_;
    cluster_ = kNoCluster;
    if (cluster.hi <= covered_) return;
    // Grow it until the signs on both sides are certain. What lies inside belongs to the cluster, also a root found before.
    double margin = std::max(cluster.hi - cluster.lo, 4 * kRounding * std::max(std::abs(cluster.lo), std::abs(cluster.hi)));
    Interval around = cluster;
    int sign_lo = 0, sign_hi = 0;
    for (; (sign_lo == 0 && around.lo > range_.lo) || (sign_hi == 0 && around.hi < range_.hi); margin *= 2) {
      if (sign_lo == 0) around.lo = std::max(range_.lo, around.lo - margin);
      if (sign_hi == 0) around.hi = std::min(range_.hi, around.hi + margin);
      sign_lo = value(c_, around.lo).sign();
      sign_hi = value(c_, around.hi).sign();
    }
    covered_ = around.hi;
    if (found_.count > 0 && found_.t[found_.count - 1] >= around.lo) return;
    if (sign_lo == 0) return add_root(around.lo);
    if (sign_hi == 0) return add_root(around.hi);
    const double root = midst(around);
    if (sign_lo == sign_hi && value(c_, root).sign() != 0) return;
    add_root(root);
  }

  // Where the m-th derivative is not zero there are at most m roots, and the derivative before it is zero in their midst.
  double midst(Interval around) const {
    std::array<double, kMaxTerms> derivative;
    std::copy(c_.begin(), c_.end(), derivative.begin());
    double root = 0.5 * (around.lo + around.hi);
    for (std::size_t degree = degree_; degree >= 1; --degree) {
      const std::span<const double> terms(derivative.data(), degree + 1);
      const double at_lo = value(terms, around.lo).value, at_hi = value(terms, around.hi).value;
      if ((at_lo < 0 && at_hi > 0) || (at_lo > 0 && at_hi < 0)) root = bracketed(terms, around.lo, around.hi);
      for (std::size_t i = 0; i < degree; ++i) derivative[i] = static_cast<double>(i + 1) * derivative[i + 1];
      const Signs signs = signs_of(bernstein({derivative.data(), degree}, around), degree - 1);
      if (signs.certain && signs.changes == 0) break;
    }
    return root;
  }

  void add_root(double t) {
    if (found_.count < degree_ && (found_.count == 0 || t > found_.t[found_.count - 1])) found_.add(t);
  }

  // ---- values ----

  // Horner's rule, with a bound of its error.
  static Bounded value(std::span<const double> c, double t) {
    double f = 0, size = 0;
    for (std::size_t i = c.size(); i-- > 0;) {
      f = f * t + c[i];
      size = size * std::abs(t) + std::abs(c[i]);
    }
    return {f, 2 * static_cast<double>(c.size()) * kRounding * size};
  }

  // The root between lo and hi, where the values have opposite signs and there is one root: Newton's method inside its bracket.
  static double bracketed(std::span<const double> c, double lo, double hi) {
    const bool rising = value(c, lo).value < 0;
    double t = 0.5 * (lo + hi);
    for (int step = 0; step < 200; ++step) {
      double f = 0, slope = 0;
      for (std::size_t i = c.size(); i-- > 0;) {
        slope = slope * t + f;
        f = f * t + c[i];
      }
      if (f == 0) return t;
      ((f < 0) == rising ? lo : hi) = t;
      double next = t - f / slope;
      if (!(next > lo && next < hi) || step % 16 == 15) next = 0.5 * (lo + hi);
      if (std::abs(next - t) <= std::numeric_limits<double>::epsilon() * std::abs(next) || next == lo || next == hi) return next;
      t = next;
    }
    return t;
  }

  static constexpr Interval kNoCluster{1, 0};

  std::span<const double> c_;
  std::size_t degree_;
  Interval range_;
  Interval cluster_ = kNoCluster;
  double covered_ = -std::numeric_limits<double>::infinity();  // end of the last cluster
  Roots<kMaxPolynomialDegree> found_;
};

}  // namespace

Roots<kMaxPolynomialDegree> certified_roots(std::span<const double> c, Interval range) {
  while (!c.empty() && c.back() == 0) c = c.first(c.size() - 1);
  if (c.size() < 2) return {};
  const double bound = root_bound(c);
  range = {std::max(range.lo, -bound), std::min(range.hi, bound)};
  if (range.empty()) return {};
  return Isolation(c, range).roots();
}

}  // namespace lute
