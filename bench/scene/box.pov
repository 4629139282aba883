// A dense scene for `lute-compare speed bench/scene`: boxes, 40 x 30 x 3.
#include "field.inc"
#declare Shape = box { -0.6, 0.6 }
Field(Shape, 40, 30)
