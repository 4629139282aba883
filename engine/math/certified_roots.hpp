// Real roots of a polynomial of any degree in a finite interval, certified: no root is lost, none is invented.
//
// Bernstein coefficients over an interval enclose the polynomial there, and the changes of their signs bound the number of its roots
// (Descartes' rule): none, no root; one, exactly one, which bracketing then finds. With more, the interval is divided by de Casteljau's
// algorithm. Every coefficient carries a bound of its rounding error, and a sign counts only beyond it; so what is decided is decided
// for the polynomial as given, whatever its scale. Where the polynomial cannot be told from zero over a whole interval (a tangent, a cluster of
// roots nearer to each other than rounding can separate) the cluster is one root.
//
// Source: B. Mourrain, F. Rouillier, M.-F. Roy, The Bernstein Basis and Real Root Isolation, 2005; J. M. Lane, R. F. Riesenfeld, Bounds
// on a Polynomial, 1981.
#pragma once

#include <span>

#include "engine/math/polynomial.hpp"

namespace lute {

// Coefficients ascending, degree at most kMaxPolynomialDegree, leading zeros allowed. Roots ascending, each once; an infinite range is cut to
// what root_bound allows. The zero polynomial has no roots.
Roots<kMaxPolynomialDegree> certified_roots(std::span<const double> c, Interval range);

}  // namespace lute
