// What an isosurface has learnt about its max_gradient once the picture is done, and the sentence that tells its author.
// Source: specification chapter 21 §8.4; the reference's limits are measured: 5 % too little; too much by 10 % and 0.5, or by 10.
#pragma once

#include <string>

namespace lute {

class Shape;  // engine/shape/shape.hpp

struct GradientRemark {
  double found = 0;     // the steepest slope between two points that a ray has asked for; 0: no ray came by
  double set = 0;       // max_gradient
  bool proven = false;  // proofs stand in for a max_gradient that is too small

  double ratio() const { return found == 0 ? 0 : found / set; }
  std::string text() const;  // empty: max_gradient is well chosen
};

// Of a shape that build(const Isosurface&, …) made; throws std::bad_cast for another. Copies of one isosurface answer once.
GradientRemark gradient_remark(const Shape& isosurface);

}  // namespace lute
