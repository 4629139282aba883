// cylinder: two ends and a radius; with open ends the inside is seen; squeezed.
// lute scenes/feature/shape/cylinder.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

cylinder { <-1.8, -0.6, 0>, <-1, 0.8, -0.3>, 0.5 }
cylinder { <-0.5, 0, -0.6>, <0.4, 0, 0.6>, 0.5 open texture { pigment { rgb <1, 0.8, 0.5> } } interior_texture { pigment { rgb <0.3, 0.4, 1> } } }
cylinder { -0.8 * y, 0.8 * y, 0.6 scale <1, 1, 0.4> rotate <30, 30, 20> translate 1.5 * x }
