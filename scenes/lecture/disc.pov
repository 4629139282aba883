// Ray and disc: the plane first, then |P - C| between the radius of the hole and the radius. A disc has no inside of its own, but cuts
// like a half-space in CSG.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.18, 0.2, 0.26> }
camera { location <0, 2.2, -8> look_at <0, 0.6, 0> angle 42 }
light_source { <-5, 8, -8> rgb 1 }
disc { <-2, 1, 0>, <0.3, 0.4, -1>, 1.2 pigment { rgb <0.85, 0.35, 0.25> } }
disc { <0.8, 1, 0>, <-0.2, 0.5, -1>, 1.2, 0.6 pigment { rgb <0.9, 0.8, 0.3> } }
disc { <2.8, 0.8, 0.5>, <1, 0.2, -0.4>, 0.9, 0.3 pigment { rgb <0.4, 0.6, 0.9> } scale <1, 1.2, 1> }
disc { <0, -0.6, 0>, y, 4 pigment { checker rgb 0.8, rgb 0.5 } }
