// intersection: what is in every part.
// lute scenes/feature/csg/intersection.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

intersection { box { -0.8, 0.8 } sphere { 0, 1.1 } plane { <1, 1, -1>, 0.9 pigment { rgb <0.3, 0.4, 1> } } rotate 30 * y translate -1.1 * x }
intersection { cylinder { -2 * x, 2 * x, 0.6 } cylinder { -2 * y, 2 * y, 0.6 } cylinder { -2 * z, 2 * z, 0.6 } rotate <20, 30, 0> translate 1.1 * x }
