// cutaway_textures: a part without a texture shows those of the solids that it cuts.
// lute scenes/feature/texture/cutaway_textures.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

#default { pigment { rgb <0.4, 1, 0.4> } finish { ambient 0.3 } }
#declare Red = sphere { <-0.4, 0, 0>, 0.6 pigment { rgb <1, 0.2, 0.2> } }
#declare Blue = sphere { <0.4, 0, 0>, 0.6 pigment { rgb <0.3, 0.3, 1> } }
#declare Knife = box { <-2, -2, -2>, <2, 0.4, -0.1> }
difference { union { object { Red } object { Blue } } object { Knife } translate <-3, 2, 0> }
difference { union { object { Red } object { Blue } } object { Knife } cutaway_textures translate <-1, 2, 0> }
difference { merge { object { Red } object { Blue } } object { Knife } cutaway_textures translate <1, 2, 0> }
difference { union { object { Red } object { Blue } } object { Knife pigment { rgb 1 } } cutaway_textures translate <3, 2, 0> }
difference { union { object { Red } object { Blue } } object { Knife } cutaway_textures pigment { gradient y scale 0.2 } translate <-3, 0, 0> }
difference { union { object { Red } sphere { <0.4, 0, 0>, 0.6 } } object { Knife } cutaway_textures translate <-1, 0, 0> }
intersection { union { object { Red } object { Blue } } object { Knife inverse } cutaway_textures translate <1, 0, 0> }
difference { union { object { Red } union { object { Blue } sphere { 0.4 * y, 0.4 } pigment { rgb <1, 1, 0> } } } object { Knife } cutaway_textures translate <3, 0, 0> }
union { difference { union { object { Red } object { Blue } } object { Knife } cutaway_textures } sphere { <0, -0.6, -0.5>, 0.2 } pigment { rgb <1, 0, 1> } translate <-3, -2, 0> }
difference { sphere { 0, 0.8 texture { pigment { rgb x } } texture { pigment { gradient y color_map { [0.5 rgbt 1] [0.5 rgb 1] } scale 0.3 } } } object { Knife } cutaway_textures translate <-1, -2, 0> }
difference { union { object { Red } object { Blue } } object { Knife } box { <-0.2, -2, -2>, <0.2, 2, 2> } cutaway_textures translate <1, -2, 0> }
difference { union { object { Red } object { Blue } } object { Knife } union { sphere { <0, 0, 0>, 0.4 } } cutaway_textures translate <3, -2, 0> }
