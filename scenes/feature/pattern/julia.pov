// julia: steps until z^2 + c escapes.
// lute scenes/feature/pattern/julia.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { julia <0.353, 0.288>, 30 interior 1, 2 color_map { [0 rgb 0] [0.2 rgb <0.9, 0.4, 0.1>] [0.5 rgb <1, 1, 0.7>] [1 rgb <0, 0.1, 0.5>] } } }
