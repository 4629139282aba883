// A dense scene for `lute-compare speed bench/scene`: lathes of cubic splines, 12 x 9 x 3.
#include "field.inc"
#declare Shape = lathe { cubic_spline 7, <0, -1.2>, <0, -0.9>, <0.8, -0.4>, <0.3, 0.1>, <0.6, 0.5>, <0, 0.8>, <0, 1> }
Field(Shape, 12, 9)
