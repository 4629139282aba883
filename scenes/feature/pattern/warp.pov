// warp: repeat with flips, black holes, turbulence and a spherical mapping.
// lute scenes/feature/pattern/warp.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

#declare Rings = pigment { onion color_map { [0 rgb <0.1, 0.1, 0.3>] [1 rgb <1, 0.9, 0.6>] } scale 0.15 }
box { <-2, 0, 0>, <0, 1.5, 1> pigment { Rings translate <0.3, 0.3, 0> warp { repeat x flip x } warp { repeat 0.8*y offset 0.2*x } } }
box { <0, 0, 0>, <2, 1.5, 1> pigment { gradient x scale 0.2 warp { black_hole <1, 0.75, 0>, 0.6 strength 1.2 falloff 2 } } }
box { <-2, -1.5, 0>, <0, 0, 1> pigment { gradient y scale 0.2 warp { turbulence 0.4 octaves 3 } rotate 30*z } }
box { <0, -1.5, 0>, <2, 0, 1> pigment { checker scale 0.1 warp { spherical } translate <1, -0.75, 0.6> } }
