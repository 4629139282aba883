// A dense scene for `lute-compare speed bench/scene`: bicubic patches, type 1, four steps, 12 x 9 x 3.
#include "field.inc"
#declare Shape = bicubic_patch { type 1 flatness 0 u_steps 4 v_steps 4
  <-0.9, 0, -0.9>, <-0.3, 0.5, -0.9>, <0.3, 0.5, -0.9>, <0.9, 0, -0.9>, <-0.9, 0.5, -0.3>, <-0.3, -0.8, -0.3>, <0.3, -0.8, -0.3>, <0.9, 0.5, -0.3>,
  <-0.9, 0.5, 0.3>, <-0.3, 0.8, 0.3>, <0.3, -0.8, 0.3>, <0.9, 0.5, 0.3>, <-0.9, 0, 0.9>, <-0.3, 0.5, 0.9>, <0.3, 0.5, 0.9>, <0.9, 0.3, 0.9> }
Field(Shape, 12, 9)
