// A dense scene for `lute-compare speed bench/scene`: triangles and smooth triangles, 40 x 30 x 3.
#include "field.inc"
#declare Shape = union { triangle { <-0.9, -0.5, 0>, <0.9, -0.5, 0>, <0, 0.9, 0> } smooth_triangle { <-0.9, 0.2, 0.4>, <-1, 0, -1>, <0.9, 0.2, 0.4>, <1, 0, -1>, <0, -0.9, 0.4>, <0, -1, -1> } }
Field(Shape, 40, 30)
