// What all patterns share. A pattern maps a point of pattern space to a value.
//
// The head of each pattern says which values evaluate() gives. What comes after is the same for all (chapter 50 §4): with a frequency
// of 0 the value is taken as it is; otherwise value · frequency + phase, modulo 1.00001, negative ones wrapped into 0...1, then the
// wave. Lengths are units of the pattern's own space, after its transformations and warps. No pattern fails: what cannot be evaluated
// is an error of the parser.
//
// To add a pattern, write `engine/texture/pattern/<name>.{hpp,cpp}` with
//   * a plain struct derived from PatternDefaults, its parameters as the scene file says them, with `kKeyword`;
//   * `double evaluate(const Name&, const dvec3& point, const PatternContext&)`;
//   * if it perturbs normals by a formula of its own instead of by its slope (chapter 50 §13.2),
//     `dvec3 perturb(const Name&, const dvec3& normal, double amount, const dvec3& point, const PatternContext&)`;
// and its include and alternative in `engine/texture/pattern/table.hpp`. The parser finds the keyword through that table; a word that
// the language does not know yet goes to LUTE_WORDS (`parser/lexer/word.hpp`) too. A pattern with parameters also needs
// `parse_arguments` (parser/statement/pattern_arguments.cpp) and `parameters` (parser/dump/pattern.cpp, which does not compile without).
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/image/color.hpp"
#include "engine/math/vec.hpp"

namespace lute {

struct Turbulence;      // engine/texture/warp.hpp
struct WaveSources;     // engine/texture/pattern/wave_sources.hpp
struct SurfaceContext;  // engine/texture/surface_context.hpp
class CompiledPigment;  // engine/texture/compiled_pigment.hpp
class InsideTest;       // engine/texture/inside_test.hpp

enum class Wave : std::uint8_t { kRamp, kTriangle, kSine, kScallop, kCubic, kPoly };

struct PatternDefaults {
  static constexpr float kFrequency = 1;  // 0: no wave or frequency processing
  static constexpr Wave kWave = Wave::kRamp;
  static constexpr bool kOwnTurbulence = false;  // the chain leaves classic turbulence to the formula
  static constexpr int kListLength = 0;  // checker 2, hexagon 3, ...: how many items a list of colours, pigments, ... has
};

// What a pattern may look at besides the point.
struct PatternContext {
  int noise_generator = 2;                 // 1, 2 or 3, already resolved
  const Turbulence* turbulence = nullptr;  // the classic turbulence of the body, for patterns with it in their formula
  const WaveSources* waves = nullptr;      // for ripples and waves
  float frequency = 1, phase = 0;          // as written, for ripples and waves
  const InsideTest* inside_test = nullptr;   // of an object pattern
  const CompiledPigment* pigment = nullptr;  // of a pigment_pattern
  const SurfaceContext* surface = nullptr;   // never null while a pattern is evaluated
};

}  // namespace lute
