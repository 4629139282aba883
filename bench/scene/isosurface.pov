// A dense scene for `lute-compare speed bench/scene`: isosurfaces of a function and of noise, 8 x 6 x 3.
#include "field.inc"
#include "functions.inc"
#declare Shape = union {
  isosurface { function { sqrt(pow(sqrt(x * x + z * z) - 0.6, 2) + y * y) - 0.25 + 0.05 * sin(12 * x) * sin(10 * z) } max_gradient 1.8
    contained_by { sphere { 0, 1 } } }
  isosurface { function { x * x + y * y + z * z - 0.1 + 0.1 * f_noise3d(4 * x, 4 * y, 4 * z) } max_gradient 2 contained_by { box { -0.4, 0.4 } } }
}
Field(Shape, 8, 6)
