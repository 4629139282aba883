// Differences whose faces coincide with those of what they cut.
// lute scenes/feature/shape/difference_coincident.pov -W160 -H120
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

difference { box { -1, 1 } box { <-0.5, -1, -0.5>, <0.5, 1.0001, 0.5> } box { <-1.001, 0, -1.001>, <0, 1.001, 0> } texture { Red } rotate <-20, 30, 0> translate -2.2 * x }
difference { cylinder { -y, y, 1 } cylinder { -1.001 * y, 1.001 * y, 0.5 } cylinder { -2 * z, 2 * z, 0.5 } texture { Green } rotate <-30, 40, 0> }
difference { sphere { 0, 1 } sphere { 0.4 * y, 0.8 } plane { -x, -0.4 } texture { Blue } rotate -30 * x translate 2.2 * x }
