// quick_color counts at quality 5 and below only: here every pigment is shown as it is.
// lute scenes/feature/texture/quick_color.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

#default { finish { ambient 0.4 } }
sphere { <-3, 2, 0>, 0.8 pigment { gradient x scale 0.3 quick_color rgb x } }
sphere { <-1, 2, 0>, 0.8 pigment { rgb y quick_colour rgb x } }
sphere { <1, 2, 0>, 0.8 pigment { quick_color rgb x } }
sphere { <3, 2, 0>, 0.8 texture { pigment { wood quick_color rgb z scale 0.2 } } }
#default { pigment { checker quick_color rgb <1, 0, 1> scale 0.3 } }
sphere { <-3, 0, 0>, 0.8 }
sphere { <-1, 0, 0>, 0.8 pigment { rgb 1 } }
#declare P = pigment { bozo quick_color rgb <0, 1, 1> scale 0.2 }
sphere { <1, 0, 0>, 0.8 pigment { P } }
sphere { <3, 0, 0>, 0.8 texture { pigment { P } } texture { pigment { rgbt <1, 1, 0, 0.5> quick_color rgb <0, 0, 1> } } }
sphere { <-3, -2, 0>, 0.8 pigment { checker pigment { P }, pigment { rgb 0.5 } scale 0.3 quick_color rgb 0.2 } }
sphere { <-1, -2, 0>, 0.8 texture { checker texture { pigment { P } }, texture { pigment { rgb 0.5 } } scale 0.3 } }
sphere { <1, -2, 0>, 0.8 pigment { P quick_color rgb -1 } }
sphere { <3, -2, 0>, 0.8 finish { phong 1 } }
