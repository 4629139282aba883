// Parallel light: every ray has the direction from point_at to the light, so shadows are equally long everywhere.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.55, 0.7, 0.9> }
camera { location <0, 5, -10> look_at <0, 0.6, 0> angle 44 }
light_source { <-20, 30, -12> rgb 0.9 parallel point_at <0, 0, 0> }
light_source { <5, 3, -8> rgb <0.15, 0.1, 0.05> parallel point_at <0, 1, 0> shadowless }
plane { y, 0 pigment { rgb <0.85, 0.82, 0.75> } finish { ambient 0.15 diffuse 0.75 } }
#for (I, -3, 3)
  cylinder { <I, 0, 0.5 * I>, <I, 1.4, 0.5 * I>, 0.15 pigment { rgb <0.7, 0.35 + 0.05 * I, 0.3> } }
  sphere { <I, 1.5, 0.5 * I>, 0.28 pigment { rgb <0.9, 0.8, 0.4> } }
#end
