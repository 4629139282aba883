// image_map: an image made by a function, with every interpolation.
// lute scenes/feature/pattern/image_map.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

#declare Picture = pigment { gradient x color_map { [0 rgb <0.9, 0.2, 0.1>] [0.5 rgb <1, 0.9, 0.3>] [1 rgb <0.1, 0.3, 0.8>] } turbulence 0.3 }
box { <0, 0, 0>, <1, 1, 1> pigment { image_map { function 6, 6 { pigment { Picture } } } } scale <1.9, 1.4, 1> translate <-1.95, 0.05, 0> }
box { <0, 0, 0>, <1, 1, 1> pigment { image_map { function 6, 6 { pigment { Picture } } interpolate 2 } } scale <1.9, 1.4, 1> translate <0.05, 0.05, 0> }
box { <0, 0, 0>, <1, 1, 1> pigment { image_map { function 6, 6 { pigment { Picture } } interpolate 3 } } scale <1.9, 1.4, 1> translate <-1.95, -1.45, 0> }
box { <0, 0, 0>, <1, 1, 1> pigment { image_map { function 6, 6 { pigment { Picture } } interpolate 4 } } scale <1.9, 1.4, 1> translate <0.05, -1.45, 0> }
