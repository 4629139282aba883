// Mirror reflection: R = D - 2(n·D)n, traced again from the point; the colour found is weighted by the reflection.
// Constant, coloured, variable by Fresnel-like falloff (reflection { min, max falloff }), and metallic.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
background { rgb <0.45, 0.6, 0.8> }
camera { location <0, 2.2, -8> look_at <0, 0.9, 0> angle 45 }
light_source { <-5, 8, -7> rgb 1 }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.2, 0.25, 0.35> } finish { ambient 0.1 diffuse 0.7 reflection 0.15 } }
sphere { <-2.6, 1, 0>, 1 pigment { rgb 0.1 } finish { diffuse 0.2 reflection 0.8 specular 0.6 roughness 0.01 } }
sphere { <0, 1, 0.5>, 1 pigment { rgb <0.8, 0.2, 0.2> } finish { diffuse 0.5 reflection { 0.05, 0.9 falloff 3 } phong 0.7 } }
sphere { <2.6, 1, 0>, 1 pigment { rgb <0.95, 0.75, 0.3> } finish { diffuse 0.3 reflection { 0.7 metallic } metallic specular 0.8 roughness 0.03 } }
box { <-1.4, 0, -2.4>, <-0.6, 0.8, -1.6> pigment { rgb <0.3, 0.7, 0.4> } finish { reflection { rgb <0.1, 0.4, 0.2> } } rotate y * 10 }
