// union: all surfaces of all parts; glass shows the ones inside.
// lute scenes/feature/csg/union.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

plane { z, 4 pigment { checker rgb 1, rgb 0.4 } }
union { sphere { <-0.5, 0, 0>, 0.8 } sphere { <0.5, 0, 0>, 0.8 } box { <-0.3, -1.1, -0.3>, <0.3, 1.1, 0.3> } pigment { rgbt <1, 0.8, 0.5, 0.6> } }
