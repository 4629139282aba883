// Isosurfaces: open in a sphere, all_intersections in CSG.
// lute scenes/feature/shape/isosurface_cut.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 2.5, -8> right 4 / 3 * x look_at <0, 0.3, 0> angle 42 }
light_source { <-4, 7, -6> rgb 0.8 }
light_source { <6, 3, -4> rgb <0.3, 0.3, 0.4> shadowless }
#default { finish { ambient 0.12 diffuse 0.75 phong 0.4 phong_size 30 } }
plane { y, -1.6 pigment { checker rgb 0.9, rgb 0.5 scale 0.8 } }
#declare Red = texture { pigment { rgb <0.9, 0.25, 0.2> } }
#declare Green = texture { pigment { rgb <0.3, 0.8, 0.3> } }
#declare Blue = texture { pigment { rgb <0.3, 0.4, 0.95> } }
#declare Glass = texture { pigment { rgbf <0.85, 0.95, 1, 0.8> } finish { reflection 0.08 phong 0.8 } }

#declare F = function { x * x + y * y + z * z - 0.8 + 0.25 * sin(7 * x) * sin(7 * y) * sin(7 * z) }
isosurface { function { F(x, y, z) } contained_by { box { <-1, -1, -0.4>, <1, 1, 1> } } open max_gradient 5 accuracy 0.0005 texture { Red } interior_texture { Blue } translate -2.2 * x }
difference { isosurface { function { F(x, y, z) } contained_by { sphere { 0, 1.2 } } max_gradient 5 accuracy 0.0005 all_intersections } box { <-2, 0.2, -2>, <2, 2, 0> } texture { Green } }
isosurface { function { F(x, y, z) } contained_by { box { -1.1, 1.1 } } max_gradient 5 accuracy 0.0005 texture { Blue } matrix <0.9, 0.3, 0, 0, 0.8, 0, 0, 0.3, -0.9, 2.2, 0, 0> }
