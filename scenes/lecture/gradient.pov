// gradient: the value is the fractional part of P·axis; a wave type (ramp, triangle, sine, scallop, cubic, poly) reshapes it, frequency and
// phase act before.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 0.2 }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y direction z }
light_source { <0, 0, -100> rgb 1 parallel point_at 0 }
#declare Map = color_map { [0 rgb <0.05, 0.1, 0.3>] [0.5 rgb <0.8, 0.4, 0.2>] [1 rgb <1, 0.95, 0.8>] }
#macro Tile(X, Y, P)
  box { <-0.9, -0.9, 0>, <0.9, 0.9, 0.1> pigment { P } finish { ambient 0 diffuse 1 } translate <X, Y, 0> }
#end
Tile(-3, 2, pigment { gradient x color_map { Map } translate 0.1 })
Tile(-1, 2, pigment { gradient y color_map { Map } frequency 2 })
Tile(1, 2, pigment { gradient <1, 1, 0> color_map { Map } triangle_wave })
Tile(3, 2, pigment { gradient x color_map { Map } sine_wave frequency 2 })
Tile(-3, 0, pigment { gradient x color_map { Map } scallop_wave })
Tile(-1, 0, pigment { gradient x color_map { Map } cubic_wave })
Tile(1, 0, pigment { gradient x color_map { Map } poly_wave 2.5 })
Tile(3, 0, pigment { gradient x color_map { Map } phase 0.3 frequency 3 })
Tile(-3, -2, pigment { gradient -y color_map { Map } rotate z * 30 })
Tile(-1, -2, pigment { gradient x color_map { Map } scale 0.4 ramp_wave })
Tile(1, -2, pigment { gradient <2, 1, 0> color_map { Map } frequency -1.5 })
Tile(3, -2, pigment { gradient y color_map { Map } scale <1, 0.6, 1> triangle_wave phase 0.25 })
