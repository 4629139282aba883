// A dense scene for `lute-compare speed bench/scene`: spheres, 40 x 30 x 3.
#include "field.inc"
#declare Shape = sphere { 0, 1 }
Field(Shape, 40, 30)
