// Ray and cylinder: in the cylinder's own frame x^2 + z^2 = r^2 is a quadratic in t; its hits count between the ends, and the end planes give
// discs unless the cylinder is open. An open cylinder shows its inside.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.22, 0.28> }
camera { location <0, 3, -8> look_at <0, 0.8, 0> angle 42 }
light_source { <-5, 8, -8> rgb 1 }
cylinder { <-2.4, 0, 0>, <-2.4, 2, 0>, 0.8 pigment { rgb <0.85, 0.35, 0.25> } finish { phong 0.5 } }
cylinder { <0, 0, 0>, <0, 2, 0>, 0.8 open pigment { rgb <0.35, 0.65, 0.4> } finish { phong 0.5 } rotate x * -20 }
cylinder { <1.6, 0.3, -1>, <3.6, 1.8, 1>, 0.5 pigment { rgb <0.35, 0.5, 0.9> } finish { phong 0.5 } }
cylinder { <-1, 0.2, -2>, <1, 0.2, -2>, 0.2 scale <1, 1, 0.5> pigment { rgb <0.9, 0.8, 0.3> } }
plane { y, 0 pigment { rgb 0.7 } }
