// Bicubic patches of type 1: flat, folded, degenerate, sheared.
// lute scenes/feature/shape/bicubic_patch_folded.pov -W160 -H120
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

#declare C = array[4] { 0, 0.7, -0.4, 0.2 }
#macro Patch(K) bicubic_patch { type 1 flatness 0.005 u_steps 4 v_steps 4 #for (I, 0, 3) #for (J, 0, 3) <I / 1.5 - 1, K * C[mod(I + J, 4)], J / 1.5 - 1> #if (I + J < 6) , #end #end #end } #end
object { Patch(1) texture { Red } interior_texture { Blue } rotate <-40, 30, 0> translate -1.8 * x }
object { Patch(-2) texture { Green } matrix <1, 0.3, 0, 0.2, -0.8, 0, 0, 0.4, 1, 1.8, 0, 0> rotate -20 * x }
bicubic_patch { type 1 flatness 0.01 u_steps 3 v_steps 3 #for (I, 0, 3) <0, 1, 0>, <I / 2 - 0.75, 0.6, -0.3>, <I / 1.5 - 1, 0, 0>, <I / 1.5 - 1, -0.6, 0.2> #if (I < 3) , #end #end texture { Blue } translate 0.4 * y }
