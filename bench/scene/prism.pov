// A dense scene for `lute-compare speed bench/scene`: prisms of bezier splines, 12 x 9 x 3.
#include "field.inc"
#declare Shape = prism { bezier_spline -0.4, 0.4, 12, <-0.8, 0>, <-0.8, -0.7>, <-0.3, -0.9>, <0.1, -0.5>, <0.1, -0.5>, <0.5, -0.9>, <1, -0.5>, <0.8, 0.2>,
  <0.8, 0.2>, <0.4, 1>, <-0.7, 0.9>, <-0.8, 0> }
Field(Shape, 12, 9)
