// A second pigment, normal or finish of an object edits the first one.
// lute scenes/feature/texture/in_place.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

#default { finish { ambient 0.3 } }
sphere { <-3, 2, 0>, 0.8 pigment { gradient x scale 0.4 } pigment { color_map { [0 rgb x] [1 rgb z] } } }
sphere { <-1, 2, 0>, 0.8 pigment { gradient x turbulence 0.5 scale 0.4 } pigment { marble } }
sphere { <1, 2, 0>, 0.8 finish { phong 1 } finish { ambient 0.6 } pigment { rgb 0.5 } }
sphere { <3, 2, 0>, 0.8 pigment { rgb 1 } normal { bumps scale 0.2 } normal { wrinkles } }
sphere { <-3, 0, 0>, 0.8 texture { pigment { rgb x } } texture { pigment { rgbt <0, 1, 0, 0.5> } } pigment { rgbt <0, 0, 1, 0.5> } }
sphere { <-1, 0, 0>, 0.8 texture { pigment { gradient y scale 0.3 } translate 0.1 pigment { color_map { [0 rgb 1] [1 rgb x] } } } }
sphere { <1, 0, 0>, 0.8 pigment { gradient y scale 0.3 } rotate 45 * z pigment { rotate 45 * z } }
sphere { <3, 0, 0>, 0.8 texture { pigment { checker rgb 1, rgb x scale 0.3 } } scale 1.1 pigment { hexagon } }
#declare T = texture { pigment { gradient x scale 0.3 } finish { phong 1 } } texture { pigment { gradient y color_map { [0.5 rgbt 1] [0.5 rgb z] } scale 0.3 } }
sphere { <-3, -2, 0>, 0.8 texture { T pigment { color_map { [0.5 rgbt 1] [0.5 rgb x] } } } }
sphere { <-1, -2, 0>, 0.8 texture { T rotate 45 * z finish { ambient 0.9 } } }
sphere { <1, -2, 0>, 0.8 texture { T } pigment { rgbt <1, 1, 0, 0.4> } }
sphere { <3, -2, 0>, 0.8 texture { T } texture { pigment { radial color_map { [0.5 rgbt 1] [0.5 rgb 1] } frequency 8 } } }
