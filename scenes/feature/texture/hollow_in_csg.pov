// hollow reaches the parts read so far; not hollow solids keep the fog out.
// lute scenes/feature/texture/hollow_in_csg.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

fog { distance 8 rgb <1, 0.9, 0.7> }
plane { z, 6 pigment { checker rgb <1, 0.2, 0.2>, rgb <0.2, 0.4, 0.8> scale 0.7 } finish { ambient 0.5 } hollow }
#default { pigment { rgbt <1, 1, 1, 0.9> } finish { ambient 0 diffuse 0.1 } }
#macro Two() sphere { <-0.45, 0, 0>, 0.45 scale <1, 1, 6> } sphere { <0.45, 0, 0>, 0.45 scale <1, 1, 6> } #end
#declare U = union { Two() }
#declare H = union { Two() hollow }
object { U translate <-3, 2, 0> }
object { H translate <-1, 2, 0> }
object { U hollow translate <1, 2, 0> }
object { H hollow off translate <3, 2, 0> }
union { Two() sphere { <0, 0, 0>, 0.3 scale <1, 1, 6> } hollow translate <-3, 0, 0> }
difference { sphere { 0, 0.9 scale <1, 1, 5> } box { <-1, 0, -9>, <0, 1, 9> } hollow translate <-1, 0, 0> }
difference { sphere { 0, 0.9 scale <1, 1, 5> } box { <-1, 0, -9>, <0, 1, 9> } translate <1, 0, 0> }
union { object { H } sphere { 0.6 * y, 0.3 scale <1, 1, 6> } translate <3, 0, 0> }
sphere { 0, 0.8 scale <1, 1, 5> hollow interior { ior 1 } translate <-3, -2, 0> }
sphere { 0, 0.8 scale <1, 1, 5> interior { ior 1 } hollow translate <-1, -2, 0> }
union { Two() interior { ior 1 } hollow translate <1, -2, 0> }
merge { Two() sphere { 0, 0.5 scale <1, 1, 5> hollow } translate <3, -2, 0> }
