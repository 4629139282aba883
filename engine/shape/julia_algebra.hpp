// Four-dimensional numbers of the Julia fractals: quaternions, and hypercomplex numbers, which are pairs of complex numbers.
// Source: specification chapter 21 §7.3.
#pragma once

#include <complex>

#include "engine/math/vec.hpp"
#include "engine/shape/julia_fractal.hpp"

namespace lute {

using Complex = std::complex<double>;

// Inline: a picture asks for them hundreds of millions of times.

inline dvec4 quaternion_product(const dvec4& a, const dvec4& b) {
  return {a.x * b.x - a.y * b.y - a.z * b.z - a.w * b.w, a.x * b.y + a.y * b.x + a.z * b.w - a.w * b.z,
          a.x * b.z - a.y * b.w + a.z * b.x + a.w * b.y, a.x * b.w + a.y * b.z - a.z * b.y + a.w * b.x};
}

inline dvec4 quaternion_square(const dvec4& z) {
  const double d = z.y * z.y + z.z * z.z + z.w * z.w;
  const double twice = 2 * z.x;
  return {z.x * z.x - d, twice * z.y, twice * z.z, twice * z.w};
}

inline dvec4 quaternion_cube(const dvec4& z) {
  const double d = z.y * z.y + z.z * z.z + z.w * z.w;
  const double k = 3 * z.x * z.x - d;
  return {z.x * (z.x * z.x - 3 * d), k * z.y, k * z.z, k * z.w};
}

inline dvec4 hypercomplex_product(const dvec4& a, const dvec4& b) {
  return {a.x * b.x - a.y * b.y - a.z * b.z + a.w * b.w, a.y * b.x + a.x * b.y - a.w * b.z - a.z * b.w,
          a.z * b.x - a.w * b.y + a.x * b.z - a.y * b.w, a.w * b.x + a.z * b.y + a.y * b.z + a.x * b.w};
}

inline dvec4 hypercomplex_square(const dvec4& z) {
  return {z.x * z.x - z.y * z.y - z.z * z.z + z.w * z.w, 2 * (z.x * z.y - z.z * z.w), 2 * (z.x * z.z - z.w * z.y),
          2 * (z.x * z.w + z.y * z.z)};
}

inline dvec4 hypercomplex_reciprocal(const dvec4& z) {
  const double m = glm::dot(z, z);
  const double q = z.x * z.w - z.y * z.z;
  const double det = ((z.x - z.w) * (z.x - z.w) + (z.y + z.z) * (z.y + z.z)) *
                     ((z.x + z.w) * (z.x + z.w) + (z.y - z.z) * (z.y - z.z));
  if (det == 0) return dvec4(0);
  return dvec4(z.x * m - 2 * z.w * q, -z.y * m - 2 * z.z * q, -z.z * m - 2 * z.y * q, z.w * m - 2 * z.x * q) / det;
}

// One of the complex functions kExp to kPwr, applied to both halves.
dvec4 hypercomplex_function(JuliaFractal::Function function, const dvec2& exponent, const dvec4& z);

}  // namespace lute
