// Clipped_by a difference, a torus, a text and an isosurface.
// lute scenes/feature/shape/clipped_by_odd_solids.pov -W160 -H120
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

box { -1, 1 hollow clipped_by { difference { sphere { 0, 1.35 } cylinder { -2 * z, 2 * z, 0.5 } } } texture { Red } interior_texture { Blue } rotate 30 * y translate -2.2 * x }
sphere { 0, 1 clipped_by { torus { 0.8, 0.35 rotate 60 * x } } texture { Green } interior_texture { Red } scale 1.1 }
cylinder { -y, y, 0.9 clipped_by { isosurface { function { sin(x * 5) * sin(y * 5) * sin(z * 5) - 0.15 } contained_by { box { -1.1, 1.1 } } max_gradient 9 inverse } } texture { Blue } interior_texture { Green } translate 2.3 * x }
