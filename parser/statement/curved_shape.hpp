// The bodies of curved primitives: what stands between `{` and the object's modifiers (specification chapter 11 §7). `sturm` is an
// object modifier that these shapes accept.
#pragma once

#include "engine/shape/julia_fractal.hpp"
#include "engine/shape/lathe.hpp"
#include "engine/shape/ovus.hpp"
#include "engine/shape/poly.hpp"
#include "engine/shape/prism.hpp"
#include "engine/shape/quadric.hpp"
#include "engine/shape/sor.hpp"
#include "engine/shape/sphere_sweep.hpp"
#include "engine/shape/superellipsoid.hpp"
#include "parser/reader.hpp"

namespace lute {

Quadric parse_quadric(Reader& reader);
Poly parse_poly(Reader& reader);                           // poly: the order, then its coefficients
Poly parse_poly_of_order(Reader& reader, int order);  // cubic (3), quartic (4): coefficients only
Poly parse_polynomial(Reader& reader);
Superellipsoid parse_superellipsoid(Reader& reader);
Ovus parse_ovus(Reader& reader);
Lathe parse_lathe(Reader& reader);
Sor parse_sor(Reader& reader);
Prism parse_prism(Reader& reader);
SphereSweep parse_sphere_sweep(Reader& reader);
JuliaFractal parse_julia_fractal(Reader& reader);

}  // namespace lute
