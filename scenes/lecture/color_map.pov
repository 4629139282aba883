// Colour maps: between two entries colours are blended linearly; two entries at one place make a step; below the first and above the last the
// end colours hold. Also filter and transmit are blended; a pigment_map blends pigments.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 0.25 }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y direction z }
light_source { <0, 0, -100> rgb 1 parallel point_at 0 }
plane { z, 2 pigment { checker rgb 0.9, rgb 0.5 scale 0.4 } finish { ambient 0.2 diffuse 0.7 } }
#macro Strip(Y, P)
  box { <-3.6, -0.4, 0>, <3.6, 0.4, 0.1> pigment { P } finish { ambient 0.1 diffuse 0.8 } translate y * Y }
#end
Strip(2.4, pigment { gradient x color_map { [0 rgb x] [0.3 rgb y] [0.3 rgb z] [1 rgb 1] } scale 8 translate -4 * x })
Strip(1.4, pigment { gradient x color_map { [0.2 rgb <1, 0.8, 0>] [0.4 rgb <0, 0.4, 0.6>] [0.7 rgb <0.7, 0.1, 0.1>] } scale 4 })
Strip(0.4, pigment { gradient x color_map { [0 rgbt <1, 0.3, 0.2, 0>] [1 rgbt <1, 0.3, 0.2, 1>] } scale 8 translate -4 * x })
Strip(-0.6, pigment { gradient x color_map { [0 rgbf <0.3, 0.8, 0.4, 1>] [0.5 rgbf <0.3, 0.8, 0.4, 0>] [1 rgbf <0.2, 0.3, 0.9, 1>] } scale 8 translate -4 * x })
Strip(-1.6, pigment { gradient x pigment_map { [0.1 checker rgb 1 rgb 0 scale 0.2] [0.9 gradient y color_map { [0 rgb z] [1 rgb x + y] } scale 0.4] } scale 8 translate -4 * x })
Strip(-2.6, pigment { gradient x color_map { [0 rgb 0] [0.25 rgb 0.2] [0.25 rgb 0.5] [0.5 rgb 0.7] [0.5 rgb <0.9, 0.6, 0.3>] [1 rgb 1] } scale 2 })
