// plane: a normal and a distance along it; moved by each kind of transformation.
// lute scenes/feature/shape/plane.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.8> } }
plane { <1, 0, -2>, -4 pigment { checker rgb 0.8, rgb <0.8, 0.3, 0.2> } }
plane { z, 3 rotate 30 * y scale <1, 2, 1> translate x pigment { checker rgb 0.7, rgb <0.3, 0.7, 0.2> } }
