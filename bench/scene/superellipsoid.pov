// A dense scene for `lute-compare speed bench/scene`: superellipsoids, 16 x 12 x 3.
#include "field.inc"
#declare Shape = superellipsoid { <0.4, 0.7> scale 0.8 }
Field(Shape, 16, 12)
