// A dense scene for `lute-compare speed bench/scene`: differences of unions, 16 x 12 x 3.
#include "field.inc"
#declare Shape = difference {
  union { sphere { -0.3, 0.6 } sphere { 0.3, 0.6 } cylinder { -0.8 * y, 0.8 * y, 0.3 } }
  union { cylinder { -x, x, 0.25 } cylinder { -z, z, 0.25 } torus { 0.5, 0.15 } }
  box { <0.2, 0.2, -1>, <1, 1, 0> }
}
Field(Shape, 16, 12)
