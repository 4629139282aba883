// Parts of a union with a whole texture, a part of one, or none.
// lute scenes/feature/texture/csg_own_texture.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

#default { pigment { rgb <0.4, 1, 0.4> } finish { ambient 0.3 } }
#macro Parts() sphere { <-0.5, 0, 0>, 0.5 } sphere { <0.5, 0, 0>, 0.5 pigment { rgb x } } #end
union { Parts() translate <-3, 2, 0> }
union { Parts() pigment { gradient y scale 0.3 } translate <-1, 2, 0> }
union { Parts() translate <1, 2, 0> pigment { gradient y scale 0.3 } }
union { Parts() texture { pigment { rgb z } } texture { pigment { gradient x color_map { [0.5 rgbt 1] [0.5 rgb 1] } scale 0.3 } } translate <3, 2, 0> }
union { sphere { <-0.5, 0, 0>, 0.5 finish { ambient 0.8 } } sphere { <0.5, 0, 0>, 0.5 } pigment { rgb x } translate <-3, 0, 0> }
union { sphere { <-0.5, 0, 0>, 0.5 normal { bumps scale 0.1 } } sphere { <0.5, 0, 0>, 0.5 } texture { pigment { rgb x } finish { phong 1 } } translate <-1, 0, 0> }
merge { Parts() pigment { rgbt <1, 1, 0, 0.5> } translate <1, 0, 0> }
union { Parts() finish { phong 1 } translate <3, 0, 0> }
difference { Parts() translate <-3, -2, 0> }
difference { sphere { 0, 0.9 pigment { rgb <1, 1, 0> } } sphere { <0.3, 0.3, -0.7>, 0.7 } translate <-1, -2, 0> }
difference { sphere { 0, 0.9 } sphere { <0.3, 0.3, -0.7>, 0.7 pigment { rgb <1, 1, 0> } } pigment { rgb z } translate <1, -2, 0> }
intersection { sphere { 0, 0.9 pigment { rgb <1, 1, 0> } } box { -0.7, 0.7 rotate 30 } pigment { checker rgb 0, rgb 1 scale 0.2 } translate <3, -2, 0> }
