// isosurface { function { ... } [contained_by { box {...} | sphere {...} }] [threshold t] [accuracy a] [max_gradient g]
//              [max_trace n | all_intersections] [evaluate p0, p1, p2] [open] }
//
//   isosurface { function { x*x + y*y + z*z - 0.25 } max_gradient 4 pigment { rgb 1 } }
//
// function: of x, y, z; where it is below the threshold (default 0) is inside. accuracy (0.001): length to which a root is bracketed
// (see depth_accuracy, container.hpp). max_gradient (1.1): a bound of the function's slope; a smaller number makes holes, a larger
// one takes longer. max_trace (1): how many surfaces a ray meets; all_intersections: 10. open: without the cuts of the container.
// evaluate: raises max_gradient where steeper slopes are seen; every ray starts anew, so that the picture depends on nothing else.
//
// The ray's passage through the container is halved until the gradient bound proves a part empty or the part is shorter than the
// accuracy: hits lie at binary fractions of the passage, as in the reference.
// Source: specification chapter 21 §8. Halving with a bound of the slope: D. Kalra, A. H. Barr, Guaranteed ray intersections with implicit
// surfaces, 1989; what the bound does not prove, slope_tree.hpp does.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include "engine/shape/container.hpp"
#include "engine/shape/shape.hpp"

namespace lute {

class Function;  // engine/function/function.hpp

struct Isosurface {
  static constexpr std::string_view kKeyword = "isosurface";
  std::shared_ptr<const Function> function;  // three parameters, one result
  Container container;
  double threshold = 0, accuracy = 0.001, max_gradient = 1.1;
  int max_trace = 1;  // 1 to 10
  std::optional<std::array<double, 3>> evaluate;
  bool open = false;
};

std::unique_ptr<Shape> build(const Isosurface& isosurface, const Transform& to_world, BuildContext& context);

}  // namespace lute
