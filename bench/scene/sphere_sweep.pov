// A dense scene for `lute-compare speed bench/scene`: sphere sweeps, linear, cubic and b_spline side by side, 9 x 7 x 3.
#include "field.inc"
#declare Shape = union {
  sphere_sweep { linear_spline 4, <-0.8, -0.6, 0>, 0.15, <-0.2, 0.7, 0>, 0.2, <0.3, -0.6, 0.2>, 0.1, <0.8, 0.5, 0>, 0.2 }
  sphere_sweep { b_spline 5, <-0.9, 0.8, -0.4>, 0.2, <-0.5, -0.6, -0.4>, 0.2, <0, 0.8, -0.4>, 0.2, <0.5, -0.8, -0.4>, 0.2, <0.9, 0.8, -0.4>, 0.2 }
  sphere_sweep { cubic_spline 5, <-0.9, 0.5, 0.5>, 0.1, <-0.5, -0.5, 0.5>, 0.15, <0, 0.5, 0.5>, 0.1, <0.5, -0.5, 0.5>, 0.15, <0.9, 0.5, 0.5>, 0.1 }
}
Field(Shape, 9, 7)
