// A merge of fifty glass balls, nested three deep.
// lute scenes/feature/shape/merge_of_fifty.pov -W160 -H120
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

#declare R = seed(17);
#macro Balls(N) merge { #for (I, 1, N) sphere { <rand(R) * 4 - 2, rand(R) * 2 - 0.6, rand(R) * 2 - 1>, 0.25 + 0.35 * rand(R) } #end } #end
merge { Balls(20) merge { Balls(15) intersection { Balls(15) box { -1.5, 1.5 } } } texture { Glass } interior { ior 1.3 } }
