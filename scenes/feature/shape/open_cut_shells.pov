// Open and clipped shells with another texture inside.
// lute scenes/feature/shape/open_cut_shells.pov -W160 -H120
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

sphere { 0, 1.2 clipped_by { plane { <0.3, 1, -0.3>, 0.3 } } texture { Red } interior_texture { Blue } translate -2.4 * x }
cone { -1.2 * y, 1.2, 1.2 * y, 0.5 open clipped_by { box { <-2, -2, -2>, <2, 2, 0> rotate 30 * y inverse } } texture { Green } interior_texture { Red } }
torus { 0.9, 0.4 clipped_by { cylinder { -2 * z, 2 * z, 0.9 } } rotate -50 * x texture { Blue } interior_texture { Green } translate 2.5 * x }
