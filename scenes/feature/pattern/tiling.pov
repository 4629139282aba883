// tiling: the pattern of Penrose that is made of kites and darts.
// lute scenes/feature/pattern/tiling.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { tiling 26 color_map { [0 rgb 0.9] [0.49 rgb <0.2, 0.4, 0.7>] [0.5 rgb 0.9] [1 rgb <0.8, 0.3, 0.1>] } rotate 90*x scale 0.3 } }
