// clipped_by: cut without a cap; the inside of the surface is seen.
// lute scenes/feature/csg/clipped_by.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

sphere { 0, 0.9 clipped_by { plane { <1, 1, -1>, 0.2 } } texture { pigment { rgb <1, 0.8, 0.5> } } interior_texture { pigment { rgb <0.3, 0.4, 1> } } translate -1.1 * x }
cylinder { -0.8 * y, 0.8 * y, 0.8 clipped_by { sphere { <0, 0, 0>, 1 } box { <-1, -1, -1>, <0.5, 0.5, 1> } } texture { pigment { rgb <1, 0.8, 0.5> } } interior_texture { pigment { rgb <0.3, 0.4, 1> } } rotate <20, 30, 0> translate 1.1 * x }
