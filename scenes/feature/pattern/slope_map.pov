// slope_map: ridges along a gradient.
// lute scenes/feature/pattern/slope_map.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { rgb <0.8, 0.8, 0.7> } normal { gradient x 0.8 slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] } scale 0.5 } }
