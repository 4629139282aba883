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
