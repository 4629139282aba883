// boxed: falls from 1 in the middle to 0 on a cube.
// lute scenes/feature/pattern/boxed.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { boxed frequency 3 color_map { [0 rgb <0.1, 0.1, 0.4>] [1 rgb <1, 0.9, 0.6>] } scale 2 } }
