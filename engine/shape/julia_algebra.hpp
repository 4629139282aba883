// Four-dimensional numbers of the Julia fractals: quaternions, and hypercomplex numbers, which are pairs of complex numbers.
// Source: specification chapter 21 §7.3.
#pragma once

#include <complex>

#include "engine/math/vec.hpp"
#include "engine/shape/julia_fractal.hpp"

namespace lute {

using Complex = std::complex<double>;

dvec4 quaternion_product(const dvec4& a, const dvec4& b);
dvec4 quaternion_square(const dvec4& z);
dvec4 quaternion_cube(const dvec4& z);

dvec4 hypercomplex_product(const dvec4& a, const dvec4& b);
dvec4 hypercomplex_square(const dvec4& z);
dvec4 hypercomplex_reciprocal(const dvec4& z);

// One of the complex functions kExp to kPwr, applied to both halves.
dvec4 hypercomplex_function(JuliaFractal::Function function, const dvec2& exponent, const dvec4& z);

}  // namespace lute
