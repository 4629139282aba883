// A dense scene for `lute-compare speed bench/scene`: tori, 20 x 15 x 3.
#include "field.inc"
#declare Shape = torus { 0.7, 0.3 }
Field(Shape, 20, 15)
