// A dense scene for `lute-compare speed bench/scene`: six-sided solids of planes, 16 x 12 x 3.
#include "field.inc"
#declare Shape = intersection { plane { x, 0.6 } plane { -x, 0.6 } plane { y, 0.6 } plane { -y, 0.6 } plane { <1, 1, 1>, 0.7 } plane { <-1, -1, -1>, 0.7 }
  bounded_by { box { -0.6, 0.6 } } }
Field(Shape, 16, 12)
