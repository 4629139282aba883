// An octahedron with inside_vector in CSG, and its twin without.
// lute scenes/feature/shape/mesh2_cut.pov -W160 -H120
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

#declare M = mesh2 { vertex_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, 0, -1> } face_indices { 8, <0, 2, 4>, <2, 1, 4>, <1, 3, 4>, <3, 0, 4>, <2, 0, 5>, <1, 2, 5>, <3, 1, 5>, <0, 3, 5> } inside_vector <0.1, 1, 0.2> }
difference { object { M } sphere { <0, 0, -0.6>, 0.6 } texture { Red } scale 1.2 rotate <10, 30, 0> translate -1.8 * x }
intersection { object { M inverse } sphere { 0, 0.8 } texture { Green } rotate <10, 20, 0> }
merge { object { M scale <-1, 1, 1> } cylinder { -1.5 * x, 1.5 * x, 0.25 } texture { Glass } interior { ior 1.2 } rotate 30 * y translate 2 * x }
