// crackle: distances to random points, and the plain cells beside them.
// lute scenes/feature/pattern/crackle.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { gradient x pigment_map { [0.5 crackle color_map { [0 rgb 0] [1 rgb 1] } scale 0.1] [0.5 crackle solid color_map { [0 rgb 0] [1 rgb 1] } scale 0.1] } scale 4 translate -2*x } }
