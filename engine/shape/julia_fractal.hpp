// julia_fractal { <cx, cy, cz, ct> [quaternion | hypercomplex] [sqr | cube | exp | ...] [max_iteration n] [precision p]
//                 [slice <a, b, c, d>, k] }
//
//   julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 15 pigment { rgb 1 } }
//
// A three-dimensional slice of a four-dimensional Julia set: the points x for which x -> f(x) + c stays bounded for max_iteration
// (default 20) steps. precision (default 20): the ray advances at least 1 / p between evaluations, so thin parts can be missed. slice: the
// fourth coordinate of a point is (k - ax - by - cz) / d, with <a, b, c, d> of unit length.
//
// The ray marches through a ball of radius 2 (hypercomplex 4), for quaternions by an estimate of the distance; where it enters or
// leaves the set the step is halved down to 1e-7. `cube` of hypercomplex iterates the square; functions other than sqr, cube and
// reciprocal begin their inside test with y in the place of z. Authors see both.
// Source: specification chapter 21 §7. The march by a lower bound of the distance: J. C. Hart, D. J. Sandin, L. H. Kauffman, Ray Tracing
// Deterministic 3-D Fractals, 1989. Squares of hypercomplex numbers taken as two complex numbers are an own derivation, which
// patch_and_field_test.cpp compares with the product written out.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct JuliaFractal {
  static constexpr std::string_view kKeyword = "julia_fractal";
  enum class Algebra : std::uint8_t { kQuaternion, kHypercomplex };
  enum class Function : std::uint8_t {
    kSqr, kCube, kReciprocal,  // the first two also for quaternions
    kExp, kLn, kSin, kAsin, kSinh, kAsinh, kCos, kAcos, kCosh, kAcosh, kTan, kAtan, kTanh, kAtanh, kPwr
  };
  dvec4 constant{0};
  Algebra algebra = Algebra::kQuaternion;
  Function function = Function::kSqr;
  dvec2 exponent{0};         // of kPwr, complex
  static constexpr int kMostIterations = 1'000'000;
  int max_iteration = 20;    // 1 to kMostIterations
  double precision = 20;     // at least 1
  dvec4 slice{0, 0, 0, 1};   // of unit length, w not 0
  double slice_distance = 0;
};

// Of the ball about the origin that the set is looked for in, before it is moved.
double search_radius(const JuliaFractal& fractal);

std::unique_ptr<Shape> build(const JuliaFractal& fractal, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
