// quartic: a torus and a piriform from their 35 coefficients, with and without sturm.
// lute scenes/feature/shape/quartic.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -0.58, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0.4, 0, 0, 0, 0, 1, 0, -0.58, 0, 0.0441>
  rotate -50 * x scale 1.4 translate -1 * x }
quartic { <4, 0, 0, -4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0>
  sturm scale 1.5 translate 0.3 * x }
