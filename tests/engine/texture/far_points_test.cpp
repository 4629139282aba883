// Coordinates that are no numbers, infinite or far beyond all integers reach patterns through warps (`warp { repeat 1e-300*x }`) and
// functions (`log(x)` of a negative x). They have no meaning, but must neither crash nor leave a table's bounds: run under UBSan.
#include <gtest/gtest.h>

#include <limits>
#include <type_traits>
#include <vector>

#include "engine/function/function.hpp"
#include "engine/texture/function_image.hpp"
#include "pattern_value.hpp"

namespace lute {
namespace {

struct Sum final : Function {
  Sum() : Function(3, 1) {}
  void evaluate(const double* arguments, double* results) const override { results[0] = arguments[0] + arguments[1] + arguments[2]; }
};

// What the table's patterns cannot do without, all variants of those that have some.
template <class Pattern>
std::vector<Pattern> variants() {
  Pattern pattern;
  std::vector<Pattern> all;
  if constexpr (requires { pattern.mapping; }) {
    pattern.mapping.image = sample_function(Sum(), 3, 2);
    for (const int map_type : {0, 1, 2, 5})
      for (const int interpolate : {0, 2, 3, 4})
        for (const bool once : {false, true}) {
          pattern.mapping.map_type = map_type;
          pattern.mapping.interpolate = interpolate;
          pattern.mapping.once = once;
          all.push_back(pattern);
        }
  } else if constexpr (std::is_same_v<Pattern, DensityFile>) {
    std::string error;
    pattern.volume = DensityVolume::parse({0, 3, 0, 1, 0, 1, 0, 255, 51}, error);
    for (pattern.interpolate = 0; pattern.interpolate < 3; ++pattern.interpolate) all.push_back(pattern);
  } else if constexpr (std::is_same_v<Pattern, FunctionPattern>) {
    pattern.function = std::make_shared<Sum>();
    all = {pattern};
  } else if constexpr (std::is_same_v<Pattern, PigmentPattern>) {
    Pigment checker;
    checker.body = body_of(Checker());
    checker.map = ColorMap{{{0, {}}, {1, {}}}};
    pattern.pigment = std::make_shared<Pigment>(checker);
    all = {pattern};
  } else if constexpr (std::is_same_v<Pattern, Tiling>) {
    for (pattern.number = 1; pattern.number <= 27; ++pattern.number) all.push_back(pattern);
  } else if constexpr (std::is_same_v<Pattern, Pavement>) {
    for (const int sides : {3, 4, 6}) {
      pattern.sides = sides;
      all.push_back(pattern);
    }
  } else {
    all = {pattern};
  }
  return all;
}

const double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
const double kCoordinates[] = {kNan, kInfinity, -kInfinity, 1e300, -1e300, 1.2345e17, -1.2345e17, 3e9, 0.4};

template <class Pattern>
class PatternAtFarPoints : public testing::Test {};

template <class Variant>
struct TypesOf;
template <class... Patterns>
struct TypesOf<std::variant<Patterns...>> {
  using Types = testing::Types<Patterns...>;
};
struct Keyword {
  template <class Pattern>
  static std::string GetName(int) { return std::string(Pattern::kKeyword); }
};
TYPED_TEST_SUITE(PatternAtFarPoints, TypesOf<AnyPattern>::Types, Keyword);

TYPED_TEST(PatternAtFarPoints, IsDefined) {
  SurfaceContext surface;
  surface.has_surface = true;
  surface.raw_normal = surface.normal = {0, 0, -1};
  surface.ray_direction = {0, 0, 1};
  for (const TypeParam& pattern : variants<TypeParam>()) {
    const PatternBody body = body_of(pattern);
    Normal normal;
    normal.body = body;
    TextureCompiler compiler{TextureSettings()};
    const CompiledPattern compiled(body, compiler);
    const CompiledNormal* bumps = compiler.normal(std::make_shared<Normal>(normal), false);
    const double nearby = compiled.value({0.4, 0.3, 0.2}, surface);
    for (const double x : kCoordinates)
      for (const double y : kCoordinates)
        for (const double z : kCoordinates) {
          compiled.value(compiled.warp({x, y, z}), surface);
          bumps->perturb({0, 0, -1}, {x, y, z}, surface);
        }
    // The tables are still what they were.
    EXPECT_EQ(compiled.value({0.4, 0.3, 0.2}, surface), nearby);
  }
}

// A list of three colours is looked up by hexagon's value.
TEST(FarPoints, HexagonKeepsToItsThreeKinds) {
  for (const double x : kCoordinates)
    for (const double z : kCoordinates) {
      const double value = value_at(body_of(Hexagon()), {x, 0, z});
      EXPECT_TRUE(value == 0 || value == 1 || value == 2) << x << ' ' << z << ": " << value;
    }
}

}  // namespace
}  // namespace lute
