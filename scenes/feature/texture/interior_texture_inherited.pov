// interior_texture of a union reaches the parts that have none.
// lute scenes/feature/texture/interior_texture_inherited.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

#default { pigment { rgb <1, 0.6, 0.2> } finish { ambient 0.4 } }
#declare In = texture { pigment { gradient y scale 0.2 color_map { [0 rgb x] [1 rgb 1] } } }
#declare Cup = difference { sphere { 0, 0.8 } plane { z, -0.2 } }
#declare Open = sphere { 0, 0.8 clipped_by { plane { -z, 0.2 } } }
object { Open translate <-3, 2, 0> }
object { Open texture { } interior_texture { In } translate <-1, 2, 0> }
object { Open pigment { rgb y } interior_texture { In } translate <1, 2, 0> }
object { Cup texture { } interior_texture { In } translate <3, 2, 0> }
union { object { Open } texture { } interior_texture { In } translate <-3, 0, 0> }
union { object { Open texture { } interior_texture { pigment { rgb z } } } pigment { rgb y } interior_texture { In } translate <-1, 0, 0> }
union { object { Open pigment { rgb y } } pigment { rgb 1 } interior_texture { In } translate <1, 0, 0> }
union { object { Open } pigment { rgb <0, 1, 1> } translate <3, 0, 0> }
#declare Open2 = object { Open texture { } interior_texture { In } }
object { Open2 rotate 90 * z translate <-3, -2, 0> }
object { Open2 pigment { rgb y } translate <-1, -2, 0> }
object { Open2 interior_texture { pigment { rgbt <0, 0, 1, 0.5> } } translate <1, -2, 0> }
object { Open material { texture { pigment { rgb y } } interior_texture { In } } translate <3, -2, 0> }
