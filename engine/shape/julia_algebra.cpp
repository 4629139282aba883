#include "engine/shape/julia_algebra.hpp"

#include <cmath>

namespace lute {

namespace {

using Function = JuliaFractal::Function;

// The formulas as they stand: what is asked for lies within the ball of escape, where nothing overflows, and the last bits that the
// library's functions of complex numbers save near 0 and 1, for several times the time, are lost in the sum with the constant.
Complex times(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
Complex over(const Complex& a, const Complex& b) {
  const double n = std::norm(b);
  return {(a.real() * b.real() + a.imag() * b.imag()) / n, (a.imag() * b.real() - a.real() * b.imag()) / n};
}
Complex times_i(const Complex& z) { return {-z.imag(), z.real()}; }
Complex over_i(const Complex& z) { return {z.imag(), -z.real()}; }

Complex logarithm(const Complex& z) { return {0.5 * std::log(std::norm(z)), std::atan2(z.imag(), z.real())}; }

Complex exponential(const Complex& z) {
  const double size = std::exp(z.real());
  return {size * std::cos(z.imag()), size * std::sin(z.imag())};
}

Complex square_root(const Complex& z) {
  const double x = z.real(), y = z.imag(), larger = std::sqrt(0.5 * (std::sqrt(std::norm(z)) + std::abs(x)));
  if (larger == 0) return {0, y};
  const double smaller = 0.5 * std::abs(y) / larger;
  return x >= 0 ? Complex(larger, std::copysign(smaller, y)) : Complex(smaller, std::copysign(larger, y));
}

Complex hyperbolic_sine(const Complex& z) {
  return {std::sinh(z.real()) * std::cos(z.imag()), std::cosh(z.real()) * std::sin(z.imag())};
}
Complex hyperbolic_cosine(const Complex& z) {
  return {std::cosh(z.real()) * std::cos(z.imag()), std::sinh(z.real()) * std::sin(z.imag())};
}

Complex tangent(double numerator_re, double numerator_im, double denominator, const Complex& otherwise) {
  return denominator == 0 ? otherwise : Complex(numerator_re / denominator, numerator_im / denominator);
}

Complex area_tangent(const Complex& z) {
  if (z.real() == 0) return {0, std::atan(z.imag())};
  return 0.5 * logarithm(over(1.0 + z, 1.0 - z));
}

Complex arc_tangent(const Complex& z) {
  if (z.imag() == 0) return {std::atan(z.real()), 0};
  if (z.real() == 0) {
    const Complex a = area_tangent(Complex(z.imag(), 0));
    return {-a.imag(), a.real()};
  }
  const Complex l = logarithm(over(1.0 - times_i(z), 1.0 + times_i(z)));
  return {-l.imag() / 2, l.real() / 2};
}

Complex power(const Complex& z, const Complex& exponent) {
  if (z == 0.0) return 0;
  const Complex e = times(exponent, logarithm(z));
  if (e.real() < -690) return 0;
  return exponential(e);
}

Complex apply(Function function, const Complex& exponent, const Complex& z) {
  const double x = z.real();
  const double y = z.imag();
  switch (function) {
    case Function::kExp: return exponential(z);
    case Function::kLn: return logarithm(z);
    case Function::kSin: return over_i(hyperbolic_sine(times_i(z)));
    case Function::kAsin: return over_i(logarithm(times_i(z) + square_root(1.0 - times(z, z))));
    case Function::kSinh: return hyperbolic_sine(z);
    case Function::kAsinh: return logarithm(z + square_root(times(z, z) + 1.0));
    case Function::kCos: return hyperbolic_cosine(times_i(z));
    case Function::kAcos: return over_i(logarithm(z + square_root(times(z, z) - 1.0)));
    case Function::kCosh: return hyperbolic_cosine(z);
    case Function::kAcosh: return logarithm(z + square_root(times(z, z) - 1.0));
    case Function::kTan: return tangent(std::sin(2 * x), std::sinh(2 * y), std::cos(2 * x) + std::cosh(2 * y), z);
    case Function::kAtan: return arc_tangent(z);
    case Function::kTanh: return tangent(std::sinh(2 * x), std::sin(2 * y), std::cosh(2 * x) + std::cos(2 * y), z);
    case Function::kAtanh: return area_tangent(z);
    case Function::kPwr: return power(z, exponent);
    case Function::kSqr:
    case Function::kCube:
    case Function::kReciprocal: break;
  }
  return times(z, z);
}

}  // namespace

dvec4 hypercomplex_function(Function function, const dvec2& exponent, const dvec4& z) {
  const Complex e(exponent.x, exponent.y);
  const Complex a = apply(function, e, Complex(z.x - z.w, z.y + z.z));
  const Complex b = apply(function, e, Complex(z.x + z.w, z.y - z.z));
  return {(a.real() + b.real()) / 2, (a.imag() + b.imag()) / 2, (a.imag() - b.imag()) / 2, (b.real() - a.real()) / 2};
}

}  // namespace lute
