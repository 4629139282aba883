#include "engine/texture/pattern/fractal.hpp"

#include <algorithm>
#include <cmath>

#include "engine/math/rounding.hpp"

namespace lute {
namespace {

FractalPoint operator+(FractalPoint a, FractalPoint b) { return {a.re + b.re, a.im + b.im}; }
FractalPoint operator-(FractalPoint a, double b) { return {a.re - b, a.im}; }
FractalPoint operator*(FractalPoint a, FractalPoint b) { return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }
FractalPoint operator*(double s, FractalPoint a) { return {s * a.re, s * a.im}; }
FractalPoint operator/(FractalPoint a, FractalPoint b) {
  const double d = norm2(b);
  return {(a.re * b.re + a.im * b.im) / d, (a.im * b.re - a.re * b.im) / d};
}

// z^exponent. Up to 4 to the bits of the reference, which decide at the border of a fractal; beyond, the reference sums the terms of
// the binomial theorem with powers by pow(), which takes ten times as long as these products and differs in the last digit.
struct Square {
  FractalPoint operator()(FractalPoint z) const {
    const double half = z.re * z.im;
    return {z.re * z.re - z.im * z.im, half + half};
  }
};
struct Cube {
  FractalPoint operator()(FractalPoint z) const {
    const double re2 = z.re * z.re, im2 = z.im * z.im;
    return {re2 * z.re - 3 * z.re * im2, 3 * re2 * z.im - im2 * z.im};
  }
};
struct FourthPower {
  FractalPoint operator()(FractalPoint z) const {
    const double re2 = z.re * z.re, im2 = z.im * z.im;
    return {re2 * re2 - 6 * re2 * im2 + im2 * im2, 4 * (re2 * z.re * z.im - z.re * im2 * z.im)};
  }
};
struct Power {
  int exponent;
  FractalPoint operator()(FractalPoint z) const {
    FractalPoint result = z;
    for (int i = 1; i < exponent; ++i) result = result * z;
    return result;
  }
};

// What the steps of a magnet make of the constant; to the bits of the reference.
class MagnetStep {
 public:
  MagnetStep(int type, FractalPoint c)
      : type_(type), c_(c), c1_(c - 1), c2_(c - 2), c12_{c1_.re * c2_.re - c.im * c.im, c.im * (c1_.re + c2_.re)} {}

  FractalPoint operator()(FractalPoint z) const {
    const FractalPoint q = type_ == 1 ? (z * z + c_ - 1) / (2 * z + c_ - 2)
                                      : (Cube()(z) + 3 * (c1_ * z) + c12_) / (three_squares(z) + 3 * (c2_ * z) + c12_ - -1.0);
    return q * q;
  }

 private:
  static FractalPoint three_squares(FractalPoint z) { return {3 * (z.re * z.re - z.im * z.im), 6 * z.re * z.im}; }

  int type_;
  FractalPoint c_, c1_, c2_, c12_;
};

// Counts steps until `escaped(z, |z|²)`. Points that never escape mostly fall into a cycle, to the last bit: once z comes back to a
// value that it had, nothing new comes, and whole turns are left out (Brent, "An improved Monte Carlo factorization algorithm", 1980).
template <class Step, class Escaped>
double iterate(const FractalSettings& settings, FractalPoint z, double nearest2, const Step& step, const Escaped& escaped) {
  FractalPoint mark = z;
  int marked_at = 0, next_mark = 8;
  bool turning = false;
  for (int n = 0; n < settings.iterations; ++n) {
    z = step(z);
    const double size2 = norm2(z);
    nearest2 = std::min(nearest2, size2);
    if (escaped(z, size2)) return exterior_value(settings, n, z);
    if (z.re == mark.re && z.im == mark.im && !turning) {
      const int period = n + 1 - marked_at, left = settings.iterations - 1 - n;
      n += left - left % period;
      turning = true;
    } else if (n + 1 == next_mark) {
      mark = z;
      marked_at = n + 1;
      next_mark = next_mark < settings.iterations ? 2 * next_mark : 0;
    }
  }
  return interior_value(settings, z, nearest2);
}

}  // namespace

double exterior_value(const FractalSettings& settings, int step, const FractalPoint& z) {
  const double f = settings.exterior_factor;
  switch (settings.exterior_type) {
    case 0: return f;
    case 1: return static_cast<double>(step) / settings.iterations;
    case 2: return z.re * f;
    case 3: return z.im * f;
    case 4: return z.re * z.re * f;
    case 5: return z.im * z.im * f;
    case 6: return std::sqrt(norm2(z)) * f;
    case 7: {
      const int m = static_cast<int>(bounded(f, 1e9));
      return m != 0 ? (step % m) / f : 0;
    }
    default: {
      const int m = static_cast<int>(bounded(f + 1, 1e9));
      return m != 0 ? (step % m) / f : 0;
    }
  }
}

double interior_value(const FractalSettings& settings, const FractalPoint& z, double nearest2) {
  const double f = settings.interior_factor;
  switch (settings.interior_type) {
    case 0: return f;
    case 1: return std::sqrt(nearest2) * f;
    case 2: return z.re * f;
    case 3: return z.im * f;
    case 4: return z.re * z.re * f;
    case 5: return z.im * z.im * f;
    default: return z.re * z.re + z.im * z.im * f;  // the factor belongs to one square only, as the reference has it
  }
}

double iterate_power(const FractalSettings& settings, int exponent, FractalPoint z, const FractalPoint& c) {
  const auto escaped = [](const FractalPoint&, double size2) { return size2 > 4; };
  const auto with = [&](const auto& power) { return iterate(settings, z, norm2(z), [&](FractalPoint p) { return power(p) + c; }, escaped); };
  switch (exponent) {
    case 2: return with(Square());
    case 3: return with(Cube());
    case 4: return with(FourthPower());
    default: return with(Power{exponent});
  }
}

double iterate_magnet(const FractalSettings& settings, int type, FractalPoint z, const FractalPoint& c, double nearest2) {
  const auto escaped = [](const FractalPoint& p, double size2) { return size2 > 10000 || norm2(p - 1) < 0.0001; };
  return iterate(settings, z, nearest2, MagnetStep(type, c), escaped);
}

}  // namespace lute
