// box: two opposite corners, in any order; turned and sheared.
// lute scenes/feature/shape/box.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

box { <-0.7, -0.7, -0.7>, <0.7, 0.7, 0.7> rotate <20, 40, 10> translate -1.1 * x }
box { <0.6, 0.6, 0.6>, <-0.6, -0.6, -0.6> matrix <1, 0.3, 0, 0, 1, 0.4, 0.2, 0, 1, 1.1, 0, 0> }
