// The recursion trace -> shade -> trace ends at max_trace_level (black beyond it), or when the weight of a ray falls below
// adc_bailout. Two facing mirrors with a ball between: the level can be counted in the picture.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 7 adc_bailout 0.001 }
background { rgb <0.2, 0.3, 0.5> }
camera { location <0.9, 1.2, -2.6> look_at <-0.1, 0.9, 1> angle 70 }
light_source { <1.5, 5, -1.5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.85, rgb <0.6, 0.25, 0.2> scale 0.5 } finish { ambient 0.2 diffuse 0.6 } }
box { <-4, 0, 3>, <4, 3, 3.2> pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 0.85 } }
box { <-4, 0, -4.2>, <4, 3, -4> pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 0.85 } }
sphere { <0, 0.6, 1>, 0.6 pigment { rgb <0.3, 0.7, 0.5> } finish { phong 0.7 reflection 0.1 } }
sphere { <-1.1, 0.4, 0.2>, 0.4 pigment { rgb 0.05 } finish { reflection 0.9 diffuse 0.1 } }
