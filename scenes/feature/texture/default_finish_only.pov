// A #default of a finish alone leaves the pigment, of a pigment alone the finish.
// lute scenes/feature/texture/default_finish_only.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

sphere { <-3, 2, 0>, 0.8 }
#default { finish { ambient 0.6 diffuse 0.3 } }
sphere { <-1, 2, 0>, 0.8 pigment { rgb <1, 0.7, 0.2> } }
sphere { <1, 2, 0>, 0.8 }
#default { pigment { rgb <0.4, 0.7, 1> } }
sphere { <3, 2, 0>, 0.8 }
sphere { <-3, 0, 0>, 0.8 finish { phong 1 } }
sphere { <-1, 0, 0>, 0.8 texture { pigment { rgb <1, 0.7, 0.2> } } }
#declare F = finish { specular 0.8 }
sphere { <1, 0, 0>, 0.8 finish { F } }
#default { finish { F } }
sphere { <3, 0, 0>, 0.8 }
sphere { <-3, -2, 0>, 0.8 texture { finish { ambient 0.4 } } }
#default { normal { bumps 0.6 scale 0.2 } }
sphere { <-1, -2, 0>, 0.8 }
sphere { <1, -2, 0>, 0.8 normal { scale 3 } }
sphere { <3, -2, 0>, 0.8 texture { pigment { rgb 1 } } }
