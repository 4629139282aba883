// Hollow and filled glass shapes inside of each other, with fade.
// lute scenes/feature/shape/hollow_glass.pov -W160 -H120
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

sphere { 0, 1.1 texture { Glass } interior { ior 1.4 } translate -1.7 * x }
sphere { 0, 0.5 texture { Red } translate -1.7 * x }
difference { box { -1, 1 } sphere { 0, 0.9 } texture { Glass } interior { ior 1.3 fade_distance 1 fade_power 2 fade_color <1, 0.6, 0.5> } rotate 25 * y translate 1.6 * x }
torus { 0.5, 0.2 hollow texture { Glass } interior { ior 1.5 } rotate -60 * x translate 1.6 * x }
