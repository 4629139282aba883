// object { X ... }: a texture is laid over that of X, pigment, normal and finish edit its top layer.
// lute scenes/feature/texture/object_copies.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

#default { pigment { rgb <0.4, 1, 0.4> } finish { ambient 0.3 } }
#declare Plain = sphere { 0, 0.8 }
#declare Painted = sphere { 0, 0.8 pigment { gradient x scale 0.4 } }
#declare Layered = sphere { 0, 0.8 texture { pigment { rgb <1, 0.8, 0> } } texture { pigment { gradient y color_map { [0.5 rgbt 1] [0.5 rgb z] } scale 0.3 } finish { phong 1 } } }
#declare Glaze = texture { pigment { gradient z color_map { [0.5 rgbt 1] [0.5 rgb <1, 0, 1>] } scale 0.4 } }
object { Plain texture { Glaze } translate <-3, 2, 0> }
object { Painted texture { Glaze } translate <-1, 2, 0> }
object { Layered texture { Glaze } translate <1, 2, 0> }
object { Layered pigment { rgbt <1, 0, 0, 0.5> } translate <3, 2, 0> }
object { Painted pigment { color_map { [0 rgb x] [1 rgb y] } } translate <-3, 0, 0> }
object { Painted pigment { rgb x } translate <-1, 0, 0> }
object { Painted translate <1, 0, 0> pigment { rotate 45 * z } }
object { Painted finish { ambient 0 } normal { bumps scale 0.1 } translate <3, 0, 0> }
object { Layered finish { ambient 0.9 } translate <-3, -2, 0> }
object { object { Painted rotate 90 * z } texture { Glaze } translate <-1, -2, 0> }
#declare Again = object { Painted rotate 45 * z texture { Glaze } }
object { Again pigment { rgbt <1, 1, 0, 0.5> } translate <1, -2, 0> }
sphere { 0, 0.8 translate <3, -2, 0> texture { Glaze } texture { Glaze rotate 90 * y translate 0.2 } }
