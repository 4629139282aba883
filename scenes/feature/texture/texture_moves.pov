// Transformations move the texture that is there; those in front of it move the object alone.
// lute scenes/feature/texture/texture_moves.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 translate <0.013, 0.007, 0> }
light_source { <-4, 6, -8> rgb 1 }

#default { pigment { gradient x color_map { [0 rgb x] [0.5 rgb 1] [1 rgb z] } scale 0.7 } finish { ambient 0.3 } }
sphere { 0, 0.8 translate <-3, 2, 0> }
sphere { 0, 0.8 translate <-1, 2, 0> pigment { rotate 45 * z } }
sphere { 0, 0.8 pigment { rotate 45 * z } translate <1, 2, 0> }
sphere { 0, 0.8 scale <1, 0.7, 1> texture { } rotate 30 * z translate <3, 2, 0> }
union { sphere { <-0.4, 0, 0>, 0.5 } sphere { <0.4, 0, 0>, 0.5 } rotate 30 * z translate <-3, 0, 0> }
union { sphere { <-0.4, 0, 0>, 0.5 } sphere { <0.4, 0, 0>, 0.5 } texture { } rotate 30 * z translate <-1, 0, 0> }
union { sphere { 0, 0.5 translate -0.4 * x } sphere { 0, 0.5 texture { } translate 0.4 * x } texture { } translate <1, 0, 0> }
union { sphere { 0, 0.5 translate -0.4 * x } sphere { 0, 0.5 translate 0.4 * x } rotate 30 * z texture { } translate <3, 0, 0> }
#declare Ball = sphere { 0, 0.8 texture { } }
#declare T = transform { rotate 30 * z translate <-3, -2, 0> }
object { Ball transform { T } }
object { Ball transform { T inverse } transform { T translate 2 * x } }
object { Ball rotate 90 * z texture { pigment { gradient y color_map { [0.5 rgbt 1] [0.5 rgb y] } scale 0.3 } translate 0.1 * y } translate <1, -2, 0> }
object { Ball material { rotate 45 * z } translate <3, -2, 0> }
