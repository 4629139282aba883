// no_bump_scale inside of textures with patterns: each enclosing texture carries normals with its own flag alone.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4,1.5,-10> look_at <4,1.5,0> right 8*x up 3*y }
light_source { <-20,30,-40> rgb 1 }
light_source { <30,-5,-20> rgb <0.3,0.2,0.4> }
background { rgb <0.1,0.2,0.3> }
#declare White = pigment { rgb 0.9 };
#declare Plain = texture { pigment { White } };
#declare Kept = texture { pigment { White } normal { wrinkles 2 no_bump_scale } };
#declare Scaled = texture { pigment { White } normal { wrinkles 2 } };
#macro Ball(Column, Row, Texture) sphere { 0, 0.47 texture { Texture } translate <Column + 0.5, Row + 0.5, 0> } #end
// The layer's flag, within one scaled space.
Ball(0, 0, texture { gradient y texture_map { [0.5 Kept] } scale 0.3 })
Ball(1, 0, texture { checker texture { Kept } texture { Plain } scale 0.3 })
Ball(2, 0, texture { average texture_map { [1 Kept] [1 pigment { rgb x } normal { granite 1 no_bump_scale scale 2 }] } scale 0.3 })
Ball(3, 0, texture { gradient y texture_map { [0.5 Kept scale 0.5] } scale <0.3, 0.6, 0.2> })
Ball(4, 0, texture { gradient y texture_map { [0.5 Kept scale <0.5, 2, 1> rotate 40*z] } scale 0.3 rotate 20 })
// The enclosing texture's flag, inherited by the entries, with their own scale.
#declare Fine = texture { pigment { White } normal { wrinkles 2 } scale 0.3 };
Ball(0, 1, texture { gradient y texture_map { [0.5 Fine] } no_bump_scale })
Ball(1, 1, texture { gradient y no_bump_scale texture_map { [0.5 Fine] } rotate 40 })
Ball(2, 1, texture { checker texture { Fine } texture { Plain } no_bump_scale rotate 30 translate 0.3 })
Ball(3, 1, texture { average texture_map { [1 Fine] [2 Kept rotate 50] } no_bump_scale })
Ball(4, 1, texture { gradient y texture_map { [0.5 pigment { White } normal { wrinkles 2 } no_bump_scale scale 0.3] } })
// Two spaces around.
#declare Inner = texture { gradient y texture_map { [0 pigment { White } normal { bumps 2 no_bump_scale }] } scale 0.3 };
#declare InnerKept = texture { gradient y texture_map { [0 pigment { White } normal { bumps 2 scale 0.4 }] } no_bump_scale rotate 40 };
Ball(0, 2, texture { gradient x texture_map { [0 Inner] [1 Plain] } scale 2 })
Ball(1, 2, texture { gradient x texture_map { [0 Inner rotate 40] [1 Plain] } scale <2, 1, 3> })
Ball(2, 2, texture { gradient x texture_map { [0 InnerKept] [1 Plain] } scale 2 })
Ball(3, 2, texture { gradient x texture_map { [0 InnerKept] [1 Plain] } no_bump_scale })
// The object's own transformations belong to the outermost texture.
object { Ball(0, 0, texture { gradient y texture_map { [0.5 Kept] } scale 0.5 }) scale 0.8 rotate 20*z translate <5, 0.2, 0> }
object { Ball(0, 0, texture { gradient y texture_map { [0.5 Fine] } no_bump_scale }) rotate 20*z translate <5.2, 0.9, 0> }
object { Ball(0, 0, texture { pigment { White } normal { wrinkles 2 no_bump_scale scale 0.5 } }) scale 0.8 rotate 20*z translate <5, 2.2, 0> }
object { Ball(0, 0, Inner) scale <0.8, 0.6, 0.9> rotate 20*z translate <6.4, 0.2, 0> }
object { Ball(0, 0, texture { checker texture { Kept } texture { Fine } }) scale <0.8, 0.6, 0.9> rotate 20*z translate <6.4, 2.0, 0> }
// What has a pattern is lit by the length that the normal has without bump scale.
Ball(7, 0, texture { gradient x texture_map { [0 pigment { White } normal { bumps 1 } finish { phong 0.1 }] } no_bump_scale scale 1.5 })
Ball(7, 1, texture { checker texture { Scaled } texture { Plain } no_bump_scale scale <0.6, 0.8, 0.7> })
// Maps within maps are blended as units, averages by their length.
#declare Map = normal { gradient y normal_map { [0 bumps 1] [1 dents 2] } scale <1, 2, 3> };
#declare Mean = normal { average normal_map { [1 bumps 1] [1 dents 2] } scale <1, 2, 3> };
Ball(7, 2, texture { pigment { White } normal { gradient x normal_map { [0 Map] [0.5 bumps 1] [1 Mean] } no_bump_scale scale 0.4 } })
// slope and aoi see the normal in the space of the enclosing texture, as long as it has become.
#macro Seen(Row, Column, Texture) sphere { 0, 0.2 texture { Texture } translate <Column*0.4 + 5.4, Row*0.4 + 1.75, -1> } #end
#declare Lit = finish { ambient 0.8 diffuse 0.2 };
Seen(0, 0, texture { gradient x texture_map { [0 pigment { aoi } normal { bumps 0.2 } finish { Lit }] } scale <1, 2, 3> })
Seen(0, 1, texture { gradient x texture_map { [0 pigment { slope y } normal { bumps 0.2 } finish { Lit }] } scale <1, 2, 3> })
Seen(1, 0, texture { gradient x texture_map { [0 pigment { slope <1, 2, -1> } normal { bumps 0.2 } finish { Lit }] } no_bump_scale scale <1, 2, 3> })
Seen(1, 1, texture { pigment { slope y } normal { bumps 0.2 no_bump_scale scale <1, 2, 3> } finish { Lit } })
