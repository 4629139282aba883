// A dense scene for `lute-compare speed bench/scene`: ovi, 16 x 12 x 3.
#include "field.inc"
#declare Shape = ovus { 0.6, 0.35 translate -0.2 * y }
Field(Shape, 16, 12)
