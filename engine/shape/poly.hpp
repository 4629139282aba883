// cubic { <20 numbers> }   quartic { <35 numbers> }   poly { order, <numbers> }   polynomial { order, xyz(i,j,k): value, ... }
//
//   poly { 2, <1, 0, 0, 0, 1, 0, 0, 1, 0, -1> pigment { rgb 1 } }
//
// order: 2 to 35; numbers: (order+1)(order+2)(order+3)/6 coefficients of x^i y^j z^k, by descending i, then j, then k. All four
// statements make one description. sturm is accepted and changes nothing: no root is lost without it.
//
// The polynomial along the ray is expanded by Horner's rule about the point nearest to the origin of the shape's space and solved on
// its monotone stretches (engine/math/polynomial.hpp), above order 4 by the certified solver (engine/math/certified_roots.hpp). Inside:
// value below 1e-4 in the shape's own space. The surface has no bounds of its own.
// Source: specification chapter 20 §5.8. The ray put into the polynomial: P. Hanrahan, Ray Tracing Algebraic Surfaces, 1983.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/shape/shape.hpp"

namespace lute {

struct Poly {
  static constexpr std::string_view kKeyword = "poly";
  int order = 2;
  std::vector<double> coefficients;  // term_count(order) of them, in the order of term_index
  bool sturm = false;

  static constexpr int kMaxOrder = 35;
  static constexpr std::size_t term_count(int order) {
    const auto n = static_cast<std::size_t>(order);
    return (n + 1) * (n + 2) * (n + 3) / 6;
  }
  // Position of the coefficient of x^i y^j z^k, i + j + k <= order.
  static constexpr std::size_t term_index(int order, int i, int j, int k) {
    const auto a = static_cast<std::size_t>(order - i);
    const auto b = static_cast<std::size_t>(order - i - j);
    const auto c = static_cast<std::size_t>(order - i - j - k);
    return a * (a + 1) * (a + 2) / 6 + b * (b + 1) / 2 + c;
  }
};

std::unique_ptr<Shape> build(const Poly& poly, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
