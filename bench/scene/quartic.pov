// A dense scene for `lute-compare speed bench/scene`: quartics in spheres, 16 x 12 x 3.
#include "field.inc"
#declare Shape = intersection { quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -1.16, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0.8, 0, 0, 0, 0, 1, 0, -1.16, 0, 0.16> } sphere { 0, 1.1 } }
Field(Shape, 16, 12)
