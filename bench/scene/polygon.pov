// A dense scene for `lute-compare speed bench/scene`: polygons with holes, 30 x 22 x 3.
#include "field.inc"
#declare Shape = polygon { 12, <-0.8, -0.8>, <0.8, -0.8>, <0.9, 0.5>, <0, 1>, <-0.8, 0.6>, <-0.8, -0.8>,
  <-0.4, -0.4>, <0.4, -0.4>, <0.4, 0.3>, <0, 0.5>, <-0.4, 0.3>, <-0.4, -0.4> }
Field(Shape, 30, 22)
