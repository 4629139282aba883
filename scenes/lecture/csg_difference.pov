// Difference: A without B is A cut with the inverse of B. The cut surface has the texture of B, or of the whole.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.24, 0.3> }
camera { location <0, 3.2, -7> look_at <0, 0.7, 0> angle 42 }
light_source { <-5, 8, -8> rgb 1 }
difference {
  box { -1, 1 }
  sphere { 0, 1.25 pigment { rgb <0.9, 0.75, 0.25> } }
  pigment { rgb <0.75, 0.3, 0.25> } finish { phong 0.4 } rotate <0, 30, 0> translate <-1.7, 1, 0>
}
difference {
  cylinder { -0.8 * y, 0.8 * y, 1 }
  cylinder { -2 * y, 2 * y, 0.6 }
  box { <-2, -0.3, 0>, <2, 0.3, -2> }
  torus { 1, 0.15 translate y * 0.6 }
  pigment { rgb <0.4, 0.6, 0.85> } finish { phong 0.4 } rotate <0, -20, 0> translate <1.6, 0.8, 0>
}
plane { y, 0 pigment { rgb 0.7 } }
