// Version 3.1: layers filter what lies below; finish { ior } sets the interior.
// lute scenes/feature/texture/old_layers.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

#version 3.1;
#default { finish { ambient 0.4 } }
sphere { <-3, 2, 0>, 0.8 texture { pigment { rgb x } } texture { pigment { rgbf <0, 1, 0, 0.5> } } }
sphere { <-1, 2, 0>, 0.8 texture { pigment { rgb 1 } } texture { pigment { rgbf <1, 0, 0, 1> } } }
sphere { <1, 2, 0>, 0.8 texture { pigment { rgb 1 } } texture { pigment { gradient x color_map { [0 rgbf <1, 0, 0, 1>] [1 rgb z] } scale 0.3 } } }
sphere { <3, 2, 0>, 0.8 pigment { rgbf <1, 1, 1, 0.9> } finish { ior 1.3 refraction 1 } }
union { sphere { -0.4 * x, 0.5 } sphere { 0.4 * x, 0.5 pigment { rgb x } } texture { pigment { rgb 1 } } texture { pigment { rgbf <0, 0, 1, 1> } } translate <-3, 0, 0> }
#declare T = texture { pigment { rgb 1 } } texture { pigment { rgbf <0, 0.7, 1, 1> } }
sphere { <-1, 0, 0>, 0.8 texture { T } }
sphere { <1, 0, 0>, 0.8 texture { T pigment { rgbf <1, 0.5, 0, 1> } } }
sphere { <3, 0, 0>, 0.8 texture { T } texture { pigment { rgbf <1, 0.5, 0, 0.5> } } }
#version 3.7;
sphere { <-3, -2, 0>, 0.8 texture { T } }
sphere { <-1, -2, 0>, 0.8 texture { pigment { rgb 1 } } texture { pigment { rgbf <0, 0.7, 1, 1> } } }
