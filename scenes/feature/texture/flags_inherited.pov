// no_shadow, no_image and no_reflection of a union reach all its parts; those of a part do not reach the others.
// lute scenes/feature/texture/flags_inherited.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

plane { z, 1 pigment { rgb 1 } finish { ambient 0.2 reflection 0.3 } }
#default { pigment { rgb <1, 0.6, 0.2> } finish { ambient 0.3 } }
#macro Two() sphere { <-0.45, 0, 0>, 0.4 } sphere { <0.45, 0, 0>, 0.4 } #end
union { Two() no_shadow translate <-3, 2, 0> }
union { Two() no_image translate <-1, 2, 0> }
union { Two() no_reflection translate <1, 2, 0> }
union { sphere { <-0.45, 0, 0>, 0.4 no_shadow } sphere { <0.45, 0, 0>, 0.4 } translate <3, 2, 0> }
union { sphere { <-0.45, 0, 0>, 0.4 no_image } sphere { <0.45, 0, 0>, 0.4 } translate <-3, 0, 0> }
union { union { Two() no_shadow } sphere { 0.5 * y, 0.3 } translate <-1, 0, 0> }
union { union { Two() } sphere { 0.5 * y, 0.3 } no_shadow translate <1, 0, 0> }
difference { sphere { 0, 0.8 no_shadow } sphere { -0.5 * z, 0.6 } translate <3, 0, 0> }
#declare U = union { Two() no_shadow }
object { U translate <-3, -2, 0> }
union { object { U } object { U rotate 90 * z } translate <-1, -2, 0> }
merge { Two() no_image no_shadow translate <1, -2, 0> }
intersection { sphere { 0, 0.8 } box { -0.6, 0.6 no_image } translate <3, -2, 0> }
