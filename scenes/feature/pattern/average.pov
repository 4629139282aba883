// average: the weighted mean of pigments.
// lute scenes/feature/pattern/average.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { average pigment_map { [1 checker rgb 0, rgb 1] [2 spherical color_map { [0 rgb <0, 0, 1>] [1 rgb <1, 1, 0>] } scale 2] } } }
