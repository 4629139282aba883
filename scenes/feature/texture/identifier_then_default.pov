// Texture identifiers keep the defaults of the place where they were declared.
// lute scenes/feature/texture/identifier_then_default.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

#default { pigment { rgb <1, 0.5, 0.2> } finish { ambient 0.5 } }
#declare T = texture { normal { bumps 0.5 scale 0.1 } }
#declare U = texture { finish { phong 1 } }
#declare P = pigment { gradient y scale 0.4 }
#declare F = finish { diffuse 0.9 }
#default { pigment { rgb <0.3, 0.6, 1> } finish { ambient 0 } }
sphere { <-3, 2, 0>, 0.8 texture { T } }
sphere { <-1, 2, 0>, 0.8 texture { U } }
sphere { <1, 2, 0>, 0.8 pigment { P } }
sphere { <3, 2, 0>, 0.8 finish { F } }
sphere { <-3, 0, 0>, 0.8 texture { T pigment { rgb y } } }
sphere { <-1, 0, 0>, 0.8 texture { U finish { ambient 0.1 } } }
sphere { <1, 0, 0>, 0.8 texture { pigment { P } } }
sphere { <3, 0, 0>, 0.8 texture { P } }
#default { texture { T } }
sphere { <-3, -2, 0>, 0.8 }
sphere { <-1, -2, 0>, 0.8 pigment { P } }
sphere { <1, -2, 0>, 0.8 texture { pigment { rgb x } } }
sphere { <3, -2, 0>, 0.8 texture { F } }
