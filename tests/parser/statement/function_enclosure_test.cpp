// No expected numbers: what functions of splines and transformations enclose must hold for points of the range.
#include <cmath>

#include "engine/function/enclosure.hpp"
#include "engine/function/function.hpp"
#include "tests/parser/statement/scene_text.hpp"

namespace lute::test {
namespace {

FunctionPtr isosurface_function(const std::string& declare, const std::string& body) {
  const Scene scene = scene_of(kVersion + declare + "isosurface { function { " + body + " } max_gradient 1 }");
  return only_object(scene).shape_if<Isosurface>()->function;
}

TEST(FunctionEnclosure, ComponentsOfSplinesAndTransformationsAreKnown) {
  const std::string declare =
      "#declare S = function { spline { natural_spline -1, <0.2, 3>, -0.3, <0.7, 1>, 0.4, <0.3, 2>, 1, <0.8, -1> } }\n"
      "#declare T = function { transform { rotate <20, 30, 40> scale <1, 2, 3> translate <1, -2, 3> } }\n";
  for (const char* body : {"S(y).x", "S(y + z).y", "sqrt(x*x + z*z) - S(y).x", "T(x, y, z).x", "T(x, y, z).y", "T(x, y, z).z + S(x).y"}) {
    const FunctionPtr function = isosurface_function(declare, body);
    for (int i = 0; i < 50; ++i) {
      // From the corner `lo` of a box along its diagonal.
      const dvec3 lo(std::sin(i), std::sin(2.3 * i), std::sin(5.7 * i)), side(0.3 + 0.3 * std::cos(3 * i));
      Enclosure ranges[3], result;
      for (int axis = 0; axis < 3; ++axis) ranges[axis] = {lo[axis], lo[axis] + side[axis], side[axis], side[axis]};
      ASSERT_TRUE(function->enclose(ranges, &result)) << body;
      double before = 0;
      for (int k = 0; k <= 20; ++k) {
        const double value = function->at(lo + k / 20.0 * side), quotient = (value - before) * 20;
        ASSERT_LE(result.lo, value) << body;
        ASSERT_GE(result.hi, value) << body;
        if (k > 0) {
          ASSERT_LE(result.slope_lo, quotient + 1e-10) << body;
          ASSERT_GE(result.slope_hi, quotient - 1e-10) << body;
        }
        before = value;
      }
    }
  }
}

}  // namespace
}  // namespace lute::test
