// Entries of maps and lists start from the #default that is in force where they stand.
// lute scenes/feature/texture/map_defaults.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

#default { pigment { rgb <1, 0.7, 0.3> } finish { ambient 0.3 } }
#declare T = texture { pigment { rgb y } }
sphere { <-3, 2, 0>, 0.8 texture { gradient x texture_map { [0.5 pigment { rgb 1 }] [0.5 finish { ambient 1 }] } scale 0.5 } }
sphere { <-1, 2, 0>, 0.8 texture { checker texture { }, texture { T } scale 0.4 } }
sphere { <1, 2, 0>, 0.8 pigment { gradient x pigment_map { [0.5 rgb 0] [0.5 gradient y scale 0.2] } scale 0.5 } }
sphere { <3, 2, 0>, 0.8 texture { tiles { texture { pigment { rgb x } } tile2 texture { } } scale 0.4 } }
#default { pigment { gradient z scale 0.3 } }
sphere { <-3, 0, 0>, 0.8 texture { gradient x texture_map { [0.5 pigment { color_map { [0 rgb 1] [1 rgb x] } }] [0.5 finish { ambient 1 }] } scale 0.5 } }
sphere { <-1, 0, 0>, 0.8 texture { checker texture { }, texture { T } scale 0.4 } }
sphere { <1, 0, 0>, 0.8 pigment { gradient x pigment_map { [0.5 rgb 0] [0.5 gradient y] } scale 0.5 } }
sphere { <3, 0, 0>, 0.8 pigment { average pigment_map { [1 rgb x] [1 color_map { [0 rgb 1] [1 rgb z] }] } } }
#declare M = texture { gradient x texture_map { [0 T] [1 pigment { rgb z }] } }
sphere { <-3, -2, 0>, 0.8 texture { M scale 0.5 } }
sphere { <-1, -2, 0>, 0.8 texture { average texture_map { [1 T] [2 pigment { rgb 1 }] } } }
union { sphere { -0.4 * x, 0.5 } sphere { 0.4 * x, 0.5 pigment { rgb 1 } } texture { M rotate 90 * z scale 0.5 } translate <1, -2, 0> }
object { sphere { 0, 0.8 texture { M } } scale 0.5 translate <3, -2, 0> }
