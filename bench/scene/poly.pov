// A dense scene for `lute-compare speed bench/scene`: polynomials of order 6 in spheres, 5 x 4 x 3.
#include "field.inc"
#declare Shape = intersection { polynomial { 6, xyz(6, 0, 0): 1, xyz(0, 6, 0): 1, xyz(0, 0, 6): 1, xyz(2, 2, 2): -2, xyz(0, 0, 0): -0.3 } sphere { 0, 1.2 } }
Field(Shape, 5, 4)
