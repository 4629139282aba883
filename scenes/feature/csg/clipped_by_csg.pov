// clipped_by on a difference, by an inverted object, and moved with its object.
// lute scenes/feature/csg/clipped_by_csg.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

difference { sphere { 0, 0.9 } sphere { 0, 0.6 } clipped_by { cylinder { -2 * z, 2 * z, 0.4 inverse } } texture { pigment { rgb <1, 0.8, 0.5> } } interior_texture { pigment { rgb <0.3, 0.4, 1> } } translate -1.1 * x }
torus { 0.6, 0.3 clipped_by { box { <-2, -2, -2>, <0.2, 2, 2> } } texture { pigment { rgb <1, 0.8, 0.5> } } interior_texture { pigment { rgb <0.3, 0.4, 1> } } rotate <-40, 30, 0> translate 1.1 * x }
