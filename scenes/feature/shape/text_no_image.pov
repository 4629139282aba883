// Text with no_image in an intersection: rays through glass pass its letters, mirrors show them; no_reflection the other way round.
// lute scenes/feature/shape/text_no_image.pov -W160 -H120
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

plane { z, 6 pigment { rgb 0.7 } finish { reflection 0.6 } }
intersection { text { ttf "timrom.ttf", "O", 1, 0 no_image scale 2.4 translate <-2.8, -0.5, 0> texture { Glass } } box { <-3, -1.2, 0.2>, <3, 1.6, 0.8> texture { Glass } } }
intersection { text { ttf "timrom.ttf", "G", 1, 0 no_reflection scale 2.4 translate <-0.6, -0.5, 0> texture { Glass } } box { <-3, -1.2, 0.2>, <3, 1.6, 0.8> texture { Green } } }
merge { text { ttf "timrom.ttf", "W", 1, 0 no_image } sphere { <0.4, 0.3, 0.5>, 0.35 } texture { Red } scale 1.6 translate <1.4, -0.4, 0> }
