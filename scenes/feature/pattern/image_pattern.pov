// image_pattern: an image as values.
// lute scenes/feature/pattern/image_pattern.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { image_pattern { function 32, 32 { sqrt(x*y) } interpolate 3 } color_map { [0 rgb <0, 0, 0.4>] [1 rgb <1, 0.9, 0.2>] } } }
