// Textures of unions within unions reach the parts that have none, from the innermost out.
// lute scenes/feature/texture/csg_nested.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

#default { pigment { rgb <0.4, 1, 0.4> } finish { ambient 0.3 } }
#macro Two() sphere { <-0.4, 0.4, 0>, 0.4 } sphere { <0.4, 0.4, 0>, 0.4 pigment { rgb x } } #end
#macro Low() sphere { <-0.4, -0.4, 0>, 0.4 } #end
union { union { Two() } Low() translate <-3, 2, 0> }
union { union { Two() pigment { rgb z } } Low() translate <-1, 2, 0> }
union { union { Two() pigment { rgb z } } Low() pigment { gradient x scale 0.2 } translate <1, 2, 0> }
union { union { Two() } Low() pigment { gradient x scale 0.2 } translate <3, 2, 0> }
union { union { Two() scale 0.5 } Low() pigment { gradient x scale 0.2 } translate <-3, 0, 0> }
union { union { union { Two() } finish { ambient 1 } } Low() pigment { gradient x scale 0.2 } translate <-1, 0, 0> }
union { difference { Two() pigment { rgb <1, 1, 0> } } Low() translate <1, 0, 0> }
difference { union { Two() Low() } box { <-1, -1, -1>, <1, 1, 0> rotate 40 * y } pigment { gradient y scale 0.2 } translate <3, 0, 0> }
#declare U = union { Two() Low() }
#declare V = union { object { U } sphere { <0.4, -0.4, 0>, 0.4 } pigment { rgb <1, 0.5, 0> } }
object { U translate <-3, -2, 0> }
object { V translate <-1, -2, 0> }
object { V pigment { rgb z } translate <1, -2, 0> }
union { object { V } pigment { rgb z } translate <3, -2, 0> }
