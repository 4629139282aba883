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

dvec4 quaternion_product(const dvec4& a, const dvec4& b) {
  return {a.x * b.x - a.y * b.y - a.z * b.z - a.w * b.w, a.x * b.y + a.y * b.x + a.z * b.w - a.w * b.z,
          a.x * b.z - a.y * b.w + a.z * b.x + a.w * b.y, a.x * b.w + a.y * b.z - a.z * b.y + a.w * b.x};
}

dvec4 quaternion_square(const dvec4& z) {
  const double d = z.y * z.y + z.z * z.z + z.w * z.w;
  const double twice = 2 * z.x;
  return {z.x * z.x - d, twice * z.y, twice * z.z, twice * z.w};
}

dvec4 quaternion_cube(const dvec4& z) {
  const double d = z.y * z.y + z.z * z.z + z.w * z.w;
  const double k = 3 * z.x * z.x - d;
  return {z.x * (z.x * z.x - 3 * d), k * z.y, k * z.z, k * z.w};
}

dvec4 hypercomplex_product(const dvec4& a, const dvec4& b) {
  return {a.x * b.x - a.y * b.y - a.z * b.z + a.w * b.w, a.y * b.x + a.x * b.y - a.w * b.z - a.z * b.w,
          a.z * b.x - a.w * b.y + a.x * b.z - a.y * b.w, a.w * b.x + a.z * b.y + a.y * b.z + a.x * b.w};
}

dvec4 hypercomplex_square(const dvec4& z) {
  return {z.x * z.x - z.y * z.y - z.z * z.z + z.w * z.w, 2 * (z.x * z.y - z.z * z.w), 2 * (z.x * z.z - z.w * z.y),
          2 * (z.x * z.w + z.y * z.z)};
}

dvec4 hypercomplex_reciprocal(const dvec4& z) {
  const double m = glm::dot(z, z);
  const double q = z.x * z.w - z.y * z.z;
  const double det = ((z.x - z.w) * (z.x - z.w) + (z.y + z.z) * (z.y + z.z)) *
                     ((z.x + z.w) * (z.x + z.w) + (z.y - z.z) * (z.y - z.z));
  if (det == 0) return dvec4(0);
  return dvec4(z.x * m - 2 * z.w * q, -z.y * m - 2 * z.z * q, -z.z * m - 2 * z.y * q, z.w * m - 2 * z.x * q) / det;
}

dvec4 hypercomplex_function(Function function, const dvec2& exponent, const dvec4& z) {
  const Complex e(exponent.x, exponent.y);
  const Complex a = apply(function, e, Complex(z.x - z.w, z.y + z.z));
  const Complex b = apply(function, e, Complex(z.x + z.w, z.y - z.z));
  return {(a.real() + b.real()) / 2, (a.imag() + b.imag()) / 2, (a.imag() - b.imag()) / 2, (b.real() - a.real()) / 2};
}

}  // namespace lute
