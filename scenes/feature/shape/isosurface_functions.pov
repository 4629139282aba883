// isosurface of functions of the standard include: torus, noise, rounded box, helix.
// lute scenes/feature/shape/isosurface_functions.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

#include "functions.inc"
isosurface { function { f_torus(x, y, z, 0.6, 0.25) } max_gradient 1.2 contained_by { box { -1, 1 } } rotate -50 * x translate <-1.1, 0.6, 0> }
isosurface { function { f_sphere(x, y, z, 0.6) + 0.3 * f_noise3d(x * 5, y * 5, z * 5) } max_gradient 3 contained_by { box { -1, 1 } } translate <0.9, 0.5, 0> }
isosurface { function { f_rounded_box(x, y, z, 0.2, 0.5, 0.4, 0.3) } max_gradient 1.2 contained_by { box { -1, 1 } } rotate <20, 30, 0> translate <-1, -0.7, 0> }
isosurface { function { f_helix1(x, y, z, 2, 6, 0.12, 0.35, 1, 1, 0) } max_gradient 2.5 contained_by { box { <-0.6, -0.8, -0.6>, <0.6, 0.8, 0.6> } }
  rotate 60 * z translate <0.8, -0.7, 0> }
