#include "engine/shape/julia_algebra.hpp"

#include <cmath>

namespace lute {

namespace {

using Function = JuliaFractal::Function;
const Complex kI(0, 1);

Complex tangent(double numerator_re, double numerator_im, double denominator, const Complex& otherwise) {
  return denominator == 0 ? otherwise : Complex(numerator_re / denominator, numerator_im / denominator);
}

Complex area_tangent(const Complex& z) {
  if (z.real() == 0) return {0, std::atan(z.imag())};
  return 0.5 * std::log((1.0 + z) / (1.0 - z));
}

Complex arc_tangent(const Complex& z) {
  if (z.imag() == 0) return {std::atan(z.real()), 0};
  if (z.real() == 0) {
    const Complex a = area_tangent(Complex(z.imag(), 0));
    return {-a.imag(), a.real()};
  }
  const Complex l = std::log((1.0 - kI * z) / (1.0 + kI * z));
  return {-l.imag() / 2, l.real() / 2};
}

Complex power(const Complex& z, const Complex& exponent) {
  if (z == 0.0) return 0;
  const Complex e = exponent * std::log(z);
  if (e.real() < -690) return 0;
  return std::exp(e);
}

Complex apply(Function function, const Complex& exponent, const Complex& z) {
  const double x = z.real();
  const double y = z.imag();
  switch (function) {
    case Function::kExp: return std::exp(z);
    case Function::kLn: return std::log(z);
    case Function::kSin: return std::sin(z);
    case Function::kAsin: return -kI * std::log(kI * z + std::sqrt(1.0 - z * z));
    case Function::kSinh: return std::sinh(z);
    case Function::kAsinh: return std::log(z + std::sqrt(z * z + 1.0));
    case Function::kCos: return std::cos(z);
    case Function::kAcos: return -kI * std::log(z + std::sqrt(z * z - 1.0));
    case Function::kCosh: return std::cosh(z);
    case Function::kAcosh: return std::log(z + std::sqrt(z * z - 1.0));
    case Function::kTan: return tangent(std::sin(2 * x), std::sinh(2 * y), std::cos(2 * x) + std::cosh(2 * y), z);
    case Function::kAtan: return arc_tangent(z);
    case Function::kTanh: return tangent(std::sinh(2 * x), std::sin(2 * y), std::cosh(2 * x) + std::cos(2 * y), z);
    case Function::kAtanh: return area_tangent(z);
    case Function::kPwr: return power(z, exponent);
    case Function::kSqr:
    case Function::kCube:
    case Function::kReciprocal: break;
  }
  return z * z;
}

}  // namespace

dvec4 hypercomplex_function(Function function, const dvec2& exponent, const dvec4& z) {
  const Complex e(exponent.x, exponent.y);
  const Complex a = apply(function, e, Complex(z.x - z.w, z.y + z.z));
  const Complex b = apply(function, e, Complex(z.x + z.w, z.y - z.z));
  return {(a.real() + b.real()) / 2, (a.imag() + b.imag()) / 2, (a.imag() - b.imag()) / 2, (b.real() - a.real()) / 2};
}

}  // namespace lute
