// pavement: polyominoes, with rounded corners.
// lute scenes/feature/pattern/pavement.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { pavement number_of_sides 4 number_of_tiles 5 pattern 7 form 2 interior 2 exterior 2 color_map { [0 rgb <0.9, 0.8, 0.6>] [0.8 rgb <0.7, 0.4, 0.2>] [1 rgb 0.1] } rotate 90*x scale 0.3 } }
