// gradient: the distance along a direction, under all six waves.
// lute scenes/feature/pattern/gradient.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

#declare Colors = color_map { [0 rgb <0.1, 0.1, 0.3>] [1 rgb <1, 0.9, 0.6>] }
#macro Strip(Row, Pattern)
  box { <-2, 1 - Row*0.5, 0>, <2, 1.45 - Row*0.5, 1> pigment { Pattern } }
#end
Strip(0, pigment { gradient x color_map { Colors } })
Strip(1, pigment { gradient x sine_wave color_map { Colors } })
Strip(2, pigment { gradient x triangle_wave color_map { Colors } })
Strip(3, pigment { gradient x scallop_wave color_map { Colors } })
Strip(4, pigment { gradient x cubic_wave frequency 2 color_map { Colors } })
Strip(5, pigment { gradient x poly_wave 3 phase 0.25 color_map { Colors } })
