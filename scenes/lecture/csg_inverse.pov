// Inverse: inside and outside change places. An intersection with an inverse object is a difference; an inverse of a whole CSG in
// an intersection cuts like the CSG; clipped_by cuts surfaces without closing them.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.24, 0.3> }
camera { location <0, 3, -7.5> look_at <0, 0.8, 0> angle 42 }
light_source { <-5, 8, -8> rgb 1 }
intersection {
  sphere { 0, 1 }
  box { <-0.5, -2, -2>, <0.5, 2, 2> inverse }
  pigment { rgb <0.8, 0.35, 0.25> } finish { phong 0.5 } rotate y * 40 translate <-2.3, 1, 0>
}
intersection {
  box { -0.85, 0.85 }
  union { sphere { <0, 0.85, 0>, 0.7 } cylinder { -2 * x, 2 * x, 0.35 } inverse }
  pigment { rgb <0.9, 0.75, 0.3> } rotate y * 30 translate <0, 0.85, 0>
}
sphere {
  0, 1
  clipped_by { plane { <-1, 0.6, -1>, 0.3 inverse } }
  pigment { rgb <0.4, 0.6, 0.85> } finish { phong 0.5 } rotate y * 60 translate <2.3, 1, 0>
}
plane { y, 0 pigment { rgb 0.7 } }
