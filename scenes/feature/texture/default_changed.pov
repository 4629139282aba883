// #default counts for what is read behind it; objects without a texture take the one in force where their statement ends.
// lute scenes/feature/texture/default_changed.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

#default { pigment { rgb <1, 0.3, 0.3> } finish { ambient 0.3 } }
sphere { <-3, 2, 0>, 0.8 }
sphere { <-1, 2, 0>, 0.8 #default { pigment { rgb <0.3, 1, 0.3> } } }
sphere { <1, 2, 0>, 0.8 pigment { rgb <0.3, 0.3, 1> } #default { finish { ambient 0.3 phong 1 } } }
sphere { <3, 2, 0>, 0.8 #default { finish { ambient 0.8 diffuse 0.1 } } pigment { rgb <0.3, 0.3, 1> } }
#declare Bare = sphere { 0, 0.8 }
#declare Painted = sphere { 0, 0.8 finish { diffuse 0.4 } }
#default { texture { pigment { gradient x scale 0.5 } finish { ambient 0.2 } } }
object { Bare translate <-3, 0, 0> }
object { Painted translate <-1, 0, 0> }
object { Bare finish { phong 0.8 } translate <1, 0, 0> }
object { Bare pigment { color_map { [0 rgb x] [1 rgb z] } } translate <3, 0, 0> }
union { object { Bare } object { Painted translate 2 * x } translate <-3, -2, 0> }
#default { texture { } }
object { Bare translate <1, -2, 0> }
#default { texture { pigment { rgb 1 } } }
object { Bare translate <3, -2, 0> }
