// What mandel, julia and magnet have in common: counting the steps until z escapes
//
// Value: exterior_type and exterior_factor choose it for points that escape (default 1, 1: the step over iterations), interior_type and
// interior_factor for those that do not (default 0, 1: the constant 1); any number, wrapped later as that of all patterns. z escapes
// where |z| > 2, with magnet where |z| > 100 or |z - 1| < 0.01. x and y count, z does not. Types out of range are errors of the parser.
// Source: specification chapter 50 §6.6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct FractalSettings : PatternDefaults {
  int iterations = 1;
  int exterior_type = 1;  // 0...8
  double exterior_factor = 1;
  int interior_type = 0;  // 0...6
  double interior_factor = 1;
};

struct FractalPoint {
  double re = 0, im = 0;
};
inline double norm2(const FractalPoint& z) { return z.re * z.re + z.im * z.im; }

// The value of a point that escaped in step `step` (from 0), and of one that never did.
double exterior_value(const FractalSettings& settings, int step, const FractalPoint& z);
double interior_value(const FractalSettings& settings, const FractalPoint& z, double nearest2);

// z^exponent + c until |z| > 2.
double iterate_power(const FractalSettings& settings, int exponent, FractalPoint z, const FractalPoint& c);
// The magnet steps 1 and 2. `nearest2` starts the smallest |z|^2.
double iterate_magnet(const FractalSettings& settings, int type, FractalPoint z, const FractalPoint& c, double nearest2);

}  // namespace lute
