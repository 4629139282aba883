// A dense scene for `lute-compare speed bench/scene`: cones, 40 x 30 x 3.
#include "field.inc"
#declare Shape = cone { -0.8 * y, 0.6, 0.8 * y, 0.2 }
Field(Shape, 40, 30)
