// inverse: inside out; the complement of a sphere in an intersection is a difference.
// lute scenes/feature/csg/inverse.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

intersection { box { -0.8, 0.8 } sphere { 0, 1 inverse } rotate <-20, 30, 0> translate -1.1 * x }
intersection { box { -0.8, 0.8 } union { sphere { 0.4, 0.7 } cylinder { -2 * z, 2 * z, 0.3 } inverse } rotate <-20, 30, 0> translate 1.1 * x }
