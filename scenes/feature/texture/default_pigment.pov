// pigment, its maps and lists start from the #default pigment: what is not written stays.
// lute scenes/feature/texture/default_pigment.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

#default { pigment { gradient x turbulence 0.3 scale 0.5 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } } finish { ambient 0.3 } }
sphere { <-3, 2, 0>, 0.8 pigment { gradient y } }
sphere { <-1, 2, 0>, 0.8 pigment { color_map { [0 rgb 0] [1 rgb 1] } } }
sphere { <1, 2, 0>, 0.8 pigment { rgb <1, 1, 0> } }
sphere { <3, 2, 0>, 0.8 pigment { rotate 90 * z } }
#declare P = pigment { wood scale 0.3 }
sphere { <-3, 0, 0>, 0.8 pigment { P } }
sphere { <-1, 0, 0>, 0.8 pigment { checker pigment { P }, pigment { bozo } } }
sphere { <1, 0, 0>, 0.8 pigment { bozo pigment_map { [0 rgb 1] [1 granite] } } }
sphere { <3, 0, 0>, 0.8 texture { pigment { P color_map { [0 rgb 1] [1 rgb <0, 0.3, 1>] } } } }
#default { pigment { P } }
sphere { <-3, -2, 0>, 0.8 }
sphere { <-1, -2, 0>, 0.8 pigment { turbulence 1 } }
#default { pigment { P translate 0.1 * x turbulence 0.5 } }
sphere { <1, -2, 0>, 0.8 }
sphere { <3, -2, 0>, 0.8 pigment { hexagon } }
