// A dense scene for `lute-compare speed bench/scene`: cubics in spheres, 16 x 12 x 3.
#include "field.inc"
#declare Shape = intersection { cubic { <1, 0, 0, 0, 0, 0, -0.6, 0, 0, 0.2, 1, 0, 0, 0, 0, 0, 1, 0, 0, -0.1> } sphere { 0, 1 } }
Field(Shape, 16, 12)
