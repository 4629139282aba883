// A dense scene for `lute-compare speed bench/scene`: ellipsoids as quadrics, each cut by a box, 20 x 15 x 3.
#include "field.inc"
#declare Shape = intersection { quadric { <1.2, 2, 3>, <0.2, 0, 0>, <0, 0, 0>, -1 } box { <-1, -0.5, -1>, <1, 1, 1> } }
Field(Shape, 20, 15)
