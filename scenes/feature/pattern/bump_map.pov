// bump_map: an image as heights.
// lute scenes/feature/pattern/bump_map.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { rgb <0.8, 0.7, 0.3> } normal { bump_map { function 64, 64 { pigment { spherical scale 0.5 translate 0.5*(x + y) color_map { [0 rgb 0] [1 rgb 1] } } } bump_size 6 interpolate 2 } translate -0.5*(x + y) scale 2 } }
