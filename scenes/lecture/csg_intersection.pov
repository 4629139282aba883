// Intersection: inside when inside every member; a hit of one member counts when it lies inside all others. The surface keeps the
// texture of the member that it belongs to.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.24, 0.3> }
camera { location <0, 2.6, -7> look_at <0, 0.8, 0> angle 42 }
light_source { <-5, 8, -8> rgb 1 }
intersection {
  sphere { <-0.5, 0, 0>, 1.2 pigment { rgb <0.85, 0.35, 0.25> } }
  sphere { <0.5, 0, 0>, 1.2 pigment { rgb <0.3, 0.55, 0.85> } }
  finish { phong 0.5 } rotate y * 25 translate <-1.7, 1.1, 0>
}
intersection {
  box { -0.8, 0.8 pigment { rgb <0.9, 0.8, 0.3> } }
  sphere { 0, 1.05 pigment { rgb <0.4, 0.7, 0.45> } }
  cylinder { -2 * y, 2 * y, 0.95 pigment { rgb 0.9 } }
  finish { phong 0.5 } rotate <20, 30, 0> translate <1.5, 1, 0>
}
plane { y, 0 pigment { rgb 0.7 } }
