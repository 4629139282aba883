// A #default normal is the start of every texture, normal and map entry behind it.
// lute scenes/feature/texture/default_normal.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

#default { pigment { rgb 1 } normal { bumps 0.8 scale 0.15 } finish { ambient 0.1 phong 0.5 } }
sphere { <-3, 2, 0>, 0.8 }
sphere { <-1, 2, 0>, 0.8 normal { wrinkles 0.8 } }
sphere { <1, 2, 0>, 0.8 normal { bumps 0 } }
sphere { <3, 2, 0>, 0.8 texture { checker texture { pigment { rgb x } }, texture { normal { bumps 0 } } scale 0.5 } }

#declare N = normal { dents 0.8 scale 0.3 }
#default { normal { N } }
sphere { <-3, 0, 0>, 0.8 }
sphere { <-1, 0, 0>, 0.8 normal { N scale 0.5 } }
sphere { <1, 0, 0>, 0.8 normal { gradient x 0.5 normal_map { [0 bumps 0.5] [1 N] } } }
sphere { <3, 0, 0>, 0.8 normal { bump_size 2 } }
#declare T = texture { pigment { rgb <1, 0.6, 0.4> } }
#default { texture { T normal { bumps 0.2 } } }
sphere { <-3, -2, 0>, 0.8 }
sphere { <-1, -2, 0>, 0.8 texture { T } }
sphere { <1, -2, 0>, 0.8 texture { pigment { rgb y } normal { N } } }
sphere { <3, -2, 0>, 0.8 texture { normal { N } pigment { rgb y } } }
