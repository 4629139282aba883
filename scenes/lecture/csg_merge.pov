// Merge: as union, but surfaces inside another member are gone: the two overlapping glass spheres are one body.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
background { rgb <0.2, 0.24, 0.3> }
camera { location <0, 2.4, -7> look_at <0, 0.8, 0> angle 42 }
light_source { <-5, 8, -8> rgb 1 }
merge {
  sphere { <-1.8, 0.9, 0>, 0.9 }
  sphere { <-0.9, 0.9, 0>, 0.9 }
  cylinder { <-1.3, 0, 0>, <-1.3, 2.2, 0>, 0.3 }
  pigment { rgbf <0.6, 0.8, 1, 0.7> } finish { phong 0.4 }
}
merge {
  box { <0.8, 0, -0.7>, <2.2, 1.2, 0.7> }
  sphere { <1.5, 1.2, 0>, 0.8 }
  pigment { rgbf <1, 0.8, 0.6, 0.8> } finish { phong 0.4 } interior { ior 1.2 }
}
plane { y, 0 pigment { checker rgb 0.8, rgb 0.6 } }
