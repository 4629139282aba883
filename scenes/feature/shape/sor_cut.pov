// Surfaces of revolution: open, sturm, cut, mirrored.
// lute scenes/feature/shape/sor_cut.pov -W160 -H120
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

#declare P = array[7] { <0.2, -1.5>, <0.5, -1.1>, <1, -0.5>, <0.4, 0.3>, <0.7, 0.8>, <0.3, 1.1>, <0.2, 1.4> }
#declare F = sor { 7, P[0], P[1], P[2], P[3], P[4], P[5], P[6] open sturm }
object { F texture { Red } interior_texture { Blue } rotate 30 * x translate -2.2 * x }
difference { sor { 7, P[0], P[1], P[2], P[3], P[4], P[5], P[6] } cylinder { -2 * z, 2 * z, 0.35 } texture { Green } }
object { F texture { Blue } interior_texture { Red } scale <0.8, -1, 1.2> rotate 60 * z translate 2.2 * x }
