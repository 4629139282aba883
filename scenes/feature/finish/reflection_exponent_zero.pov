// reflection exponent 0: the exponent is infinite, so that nothing darker than 1 is reflected, by any form of the keyword.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 right 4/3*x }
light_source { <3, 5, -10> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, -1 pigment { checker rgb 0.2 rgb 0.9 } }
sphere { <-1.6, 0, 0>, 0.7 pigment { rgb <0.5, 0.3, 0.2> } finish { reflection { 0.5 exponent 0 } } }
sphere { 0, 0.7 pigment { rgb <0.2, 0.5, 0.3> } finish { reflection { 0.1, 0.9 exponent 0 } } }
sphere { <1.6, 0, 0>, 0.7 pigment { rgb <0.3, 0.2, 0.5> } finish { reflection 0.5 reflection_exponent 0 } }
