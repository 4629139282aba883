// torus with a negative major radius: the tube, seen through the smaller ring of the radii as written.
// lute scenes/feature/shape/torus_negative.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

torus { -0.8, 0.25 translate <-1.1, 0.7, 0> }
torus { -0.8, -0.25 rotate -20 * x translate <1.1, 0.7, 0> }
torus { -0.2, 0.6 rotate 20 * z scale <1, 1.2, 1> translate <-1.1, -0.7, 0> }
torus { -0.6, -0.3 rotate <-60, 20, 0> uv_mapping pigment { checker rgb 1, rgb <0.8, 0.2, 0.1> scale 0.1 } translate <1.1, -0.7, 0> }
