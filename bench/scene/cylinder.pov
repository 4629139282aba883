// A dense scene for `lute-compare speed bench/scene`: cylinders, 40 x 30 x 3.
#include "field.inc"
#declare Shape = cylinder { -0.8 * y, 0.8 * y, 0.55 }
Field(Shape, 40, 30)
