#include "engine/math/certified_roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include "engine/math/bracketed_root.hpp"

namespace lute {

namespace {

constexpr double kRounding = std::numeric_limits<double>::epsilon() / 2;
constexpr std::size_t kMaxTerms = kMaxPolynomialDegree + 1;

// Not the middle: roots of scenes like to lie at binary fractions, and a root at the border of two halves takes both of them long.
constexpr double kShare = 0.4843;

// A value and a bound of its error.
struct Bounded {
  double value = 0, error = 0;

  int sign() const { return value > error ? 1 : value < -error ? -1 : 0; }
};

// Coefficients and bounds of their errors.
struct Terms {
  std::array<double, kMaxTerms> value, error;

  int sign(std::size_t i) const { return Bounded{value[i], error[i]}.sign(); }
};

// What the rounding of the bounds themselves can take from them in as many steps of sums and products as the degree.
double inflation_of(std::size_t degree) { return 1 + 9 * kRounding * static_cast<double>(degree + 1); }

constexpr auto kBinomial = [] {
  std::array<std::array<double, kMaxTerms>, kMaxTerms> binomial{};
  for (std::size_t n = 0; n < kMaxTerms; ++n) {
    binomial[n][0] = 1;
    for (std::size_t i = 1; i <= n; ++i) binomial[n][i] = binomial[n][i - 1] * static_cast<double>(n - i + 1) / static_cast<double>(i);
  }
  return binomial;
}();

// Bernstein coefficients over an interval: a Taylor shift to its beginning, in units of its length, then sums of divided terms. The degree may
// be a constant of type std::integral_constant.
template <class Degree>
void bernstein(const double* c, Degree degree, Interval over, Terms& b) {
  std::copy(c, c + degree + 1, b.value.begin());
  std::fill(b.error.begin(), b.error.begin() + degree + 1, 0.0);
  for (std::size_t i = 0; over.lo != 0 && i < degree; ++i)
    for (std::size_t j = degree; j-- > i;) {
      const double product = over.lo * b.value[j + 1];
      const double value = b.value[j] + product;
      b.error[j] = (b.error[j] + std::abs(over.lo) * b.error[j + 1] + kRounding * (std::abs(product) + std::abs(value))) * (1 + 8 * kRounding);
      b.value[j] = value;
    }
  const double width = over.hi - over.lo;
  double power = 1;
  for (std::size_t i = 0; i <= degree; ++i) {
    const double factor = power / kBinomial[degree][i];
    b.value[i] *= factor;
    b.error[i] = (b.error[i] * factor + (2 * static_cast<double>(i) + 6) * kRounding * std::abs(b.value[i])) * (1 + 8 * kRounding);
    power *= width;
  }
  for (std::size_t i = 1; i <= degree; ++i)
    for (std::size_t j = degree; j >= i; --j) {
      const double value = b.value[j] + b.value[j - 1];
      b.error[j] += b.error[j - 1] + kRounding * std::abs(value);
      b.value[j] = value;
    }
  const double inflation = inflation_of(degree);
  for (std::size_t i = 0; i <= degree; ++i) b.error[i] *= inflation;
}

// De Casteljau's scheme at kShare: `left` and `b` become the coefficients over both parts. Each step is (1 - share) a + share b; the factors
// are exact enough to be counted as two roundings each, four with those of the product and the sum.
template <class Degree>
void split(Terms& b, Degree degree, Terms& left) {
  constexpr double kRest = 1 - kShare;
  left.value[0] = b.value[0];
  left.error[0] = b.error[0];
  for (std::size_t i = 1; i <= degree; ++i) {
    double value = b.value[0], error = b.error[0] + 4 * kRounding * std::abs(value);
    for (std::size_t j = 0; j + i <= degree; ++j) {
      const double next_value = b.value[j + 1], next_error = b.error[j + 1] + 4 * kRounding * std::abs(next_value);
      b.value[j] = kRest * value + kShare * next_value;
      b.error[j] = kRest * error + kShare * next_error;
      value = next_value;
      error = next_error;
    }
    left.value[i] = b.value[0];
    left.error[i] = b.error[0];
  }
  const double inflation = inflation_of(degree);
  for (std::size_t i = 0; i <= degree; ++i) {
    left.error[i] *= inflation;
    b.error[i] *= inflation;
  }
}

struct Signs {
  bool certain = true;  // all of them
  bool any = false;     // at least one, by a margin that is worth a division
  int changes = 0;
};

// A coefficient this many times its error is clear. Less clear ones make a cluster: dividing them on and on tells nothing new.
constexpr double kClear = 16;

template <class Degree>
Signs signs_of(const Terms& b, Degree degree) {
  Signs signs;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double low = kInfinity, high = -kInfinity, clear = -kInfinity;
  for (std::size_t i = 0; i <= degree; ++i) {
    low = std::min(low, b.value[i] - b.error[i]);
    high = std::max(high, b.value[i] + b.error[i]);
    clear = std::max(clear, std::abs(b.value[i]) - kClear * b.error[i]);
  }
  signs.any = clear > 0;
  if (low > 0 || high < 0) return signs;
  int last = 0;
  for (std::size_t i = 0; i <= degree; ++i) {
    const int sign = b.sign(i);
    if (sign == 0) {
      signs.certain = false;
      continue;
    }
    if (last != 0 && sign != last) ++signs.changes;
    last = sign;
  }
  return signs;
}

template <class Degree>
class Isolation {
 public:
  Isolation(std::span<const double> c, Degree degree, Interval range) : c_(c), degree_(degree), range_(range) {}

  Roots<kMaxPolynomialDegree> roots() {
    Terms b;
    bernstein(c_.data(), degree_, range_, b);
    divide(range_.lo, range_.hi, b, 0);
    close_cluster();
    return found_;
  }

 private:
  // Overwrites the coefficients.
  void divide(double lo, double hi, Terms& b, int depth) {
    if (found_.count == degree_) return;
    Signs signs = signs_of(b, degree_);
    if (!signs.any) {  // errors were inherited from a wider interval: begin anew
      bernstein(c_.data(), degree_, {lo, hi}, b);
      signs = signs_of(b, degree_);
    }
    if (signs.certain && signs.changes == 0) return close_cluster();
    if (signs.certain && signs.changes == 1) {
      close_cluster();
      if (const double root = bracketed(c_.data(), degree_, lo, hi); root > covered_) add_root(root);
      return;
    }
    constexpr int kDeepest = 120;
    const double middle = lo + kShare * (hi - lo);
    if (!signs.any || depth == kDeepest || !(middle > lo && middle < hi)) return extend_cluster(lo, hi);
    Terms left;
    split(b, degree_, left);
    divide(lo, middle, left, depth + 1);
    divide(middle, hi, b, depth + 1);
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
    Terms b;
    for (std::size_t degree = degree_; degree >= 1; --degree) {
      const std::span<const double> terms(derivative.data(), degree + 1);
      const double at_lo = value(terms, around.lo).value, at_hi = value(terms, around.hi).value;
      if ((at_lo < 0 && at_hi > 0) || (at_lo > 0 && at_hi < 0)) root = bracketed(derivative.data(), degree, around.lo, around.hi);
      for (std::size_t i = 0; i < degree; ++i) derivative[i] = static_cast<double>(i + 1) * derivative[i + 1];
      bernstein(derivative.data(), degree - 1, around, b);
      const Signs signs = signs_of(b, degree - 1);
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

  // The root between lo and hi, where the values have opposite signs and there is one root.
  template <class AnyDegree>
  static double bracketed(const double* c, AnyDegree degree, double lo, double hi) {
    return bracketed_root(c, degree, {lo, hi, value({c, degree + 1}, lo).value, 0.5 * (lo + hi)});
  }

  static constexpr Interval kNoCluster{1, 0};

  std::span<const double> c_;
  Degree degree_;
  Interval range_;
  Interval cluster_ = kNoCluster;
  double covered_ = -std::numeric_limits<double>::infinity();  // end of the last cluster
  Roots<kMaxPolynomialDegree> found_;
};

}  // namespace

Roots<kMaxPolynomialDegree> certified_roots(std::span<const double> c, Interval range) {
  while (!c.empty() && c.back() == 0) c = c.first(c.size() - 1);
  if (c.size() < 2) return {};
  if (!(range.lo >= -1 && range.hi <= 1)) {  // what is short already needs no bound
    const double bound = root_bound(c);
    range = {std::max(range.lo, -bound), std::min(range.hi, bound)};
  }
  if (range.empty()) return {};
  using SphereSweepDegree = std::integral_constant<std::size_t, 10>;
  if (c.size() == 11) return Isolation(c, SphereSweepDegree(), range).roots();
  return Isolation(c, c.size() - 1, range).roots();
}

}  // namespace lute
