// interior of a union reaches its parts without one; of an intersection and of copies too.
// lute scenes/feature/texture/csg_interior.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

plane { z, 4 pigment { checker rgb 1, rgb <0.2, 0.4, 0.8> scale 0.5 } finish { ambient 0.5 } }
#default { pigment { rgbt <1, 1, 1, 0.9> } finish { ambient 0 diffuse 0.1 } }
#declare Glass = interior { ior 1.4 }
#declare Tint = interior { ior 1.1 fade_distance 0.5 fade_power 1001 fade_color <1, 0.5, 0.2> }
#macro Two() sphere { <-0.45, 0, 0>, 0.45 } sphere { <0.45, 0, 0>, 0.45 interior { ior 1.1 } } #end
union { Two() translate <-3, 2, 0> }
union { Two() interior { Glass } translate <-1, 2, 0> }
merge { Two() interior { Tint } translate <1, 2, 0> }
intersection { sphere { 0, 0.9 } box { -0.6, 0.6 rotate 30 } interior { Glass } translate <3, 2, 0> }
#declare Ball = sphere { 0, 0.8 interior { Glass } }
object { Ball translate <-3, 0, 0> }
object { Ball interior { Tint } translate <-1, 0, 0> }
object { Ball interior { fade_distance 0.5 fade_power 2 fade_color x } translate <1, 0, 0> }
union { object { Ball } interior { Tint } translate <3, 0, 0> }
#declare M = material { texture { pigment { rgbt <1, 0.6, 0.6, 0.8> } } interior { ior 1.6 } }
sphere { <-3, -2, 0>, 0.8 material { M } }
object { Ball material { M } translate <-1, -2, 0> }
union { Two() material { M } translate <1, -2, 0> }
sphere { <3, -2, 0>, 0.8 interior { Glass } material { texture { pigment { rgbt <0.5, 1, 0.5, 0.8> } } } }
