// brick: courses of brick_size with mortar between, every second course (of y) shifted by half a brick.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.6, 0.7, 0.85> }
camera { location <0, 2.5, -9> look_at <0, 1.2, 0> angle 44 }
light_source { <-5, 9, -9> rgb 1 }
plane { z, 3.003 pigment { brick rgb 0.85, rgb <0.6, 0.25, 0.2> brick_size <1, 0.45, 0.5> mortar 0.06 } }
box { <-1, 0, -1>, <1, 2, 1> pigment { brick rgb 0.7, rgb <0.75, 0.5, 0.3> scale 0.08 translate 0.003 } rotate y * 35 translate <-2, 0.013, 0> }
sphere { <1.8, 1.1, -0.5>, 1.1 pigment { brick pigment { rgb <0.2, 0.3, 0.5> }, pigment { rgb <0.9, 0.85, 0.7> } brick_size <0.5, 0.25, 0.5> mortar 0.04 translate 0.007 } }
plane { y, -0.001 pigment { rgb <0.45, 0.5, 0.4> } }
