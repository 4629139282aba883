// Ray and cone: x^2 + z^2 = (k·y)^2 in the cone's own frame, cut to one half and between the ends; closed by discs unless open.
// A full cone, a frustum, an open frustum seen from above, and one whose two radii are nearly equal.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.22, 0.28> }
camera { location <0, 3.4, -8> look_at <0, 0.9, 0> angle 42 }
light_source { <-5, 8, -8> rgb 1 }
cone { <-2.6, 0, 0>, 1, <-2.6, 2.2, 0>, 0 pigment { rgb <0.85, 0.35, 0.25> } finish { phong 0.5 } }
cone { <0, 0, 0>, 0.9, <0, 1.6, 0>, 0.4 pigment { rgb <0.9, 0.8, 0.3> } finish { phong 0.5 } }
cone { <2.4, 0, 0>, 0.4, <2.4, 1.8, 0>, 1 open pigment { rgb <0.35, 0.65, 0.4> } finish { phong 0.5 } }
cone { <-1.6, 0.3, -2>, 0.3, <1.4, 0.31, -2.2>, 0.301 pigment { rgb <0.4, 0.5, 0.9> } }
plane { y, 0 pigment { rgb 0.7 } }
