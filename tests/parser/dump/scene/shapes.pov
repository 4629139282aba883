#version 3.7;
global_settings { assumed_gamma 1 }
// Every primitive once, with what it can be told.
sphere { <1, 2, 3>, 0.5 }
box { <-1, -2, -3>, <3, 2, 1> }
plane { <1, 1, 0>, 2 }
cylinder { 0, 2*y, 0.25 open }
cone { -y, 1, y, 0.5 }
disc { <0, 1, 0>, y, 2, 0.5 }
torus { 2, 0.5 sturm }
ovus { 1, 0.75 }
superellipsoid { <0.25, 1.5> }
triangle { 0, x, y }
smooth_triangle { 0, -z, x, <0.1, 0, -1>, y, <0, 0.1, -1> }
polygon { 5, 0, x, x + y, y, 0 }
quadric { <1, 2, 3>, <4, 5, 6>, <7, 8, 9>, 10 }
cubic { <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, -1> }
poly { 2, <1, 0, 0, 0, 1, 0, 0, 1, 0, -1> sturm }
polynomial { 2, xyz(2, 0, 0): 1, xyz(0, 0, 0): -1 }
quartic { <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1> }
lathe { cubic_spline 4, <0.5, -2>, <0.5, -1>, <1, 0>, <0.25, 1> sturm }
sor { 4, <0.5, -1>, <0.5, 0>, <0.75, 1>, <0.5, 2> open }
prism { linear_sweep linear_spline 0, 1, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> }
prism { conic_sweep quadratic_spline 0.5, 1, 5, <-1, 1>, <0, 0>, <1, 0>, <0, 1>, <0, 0> open }
sphere_sweep { b_spline 4, 0, 0.1, x, 0.2, x + y, 0.3, y, 0.4 tolerance 0.001 }
bicubic_patch { type 1 flatness 0.1 u_steps 2 v_steps 3
  <0, 0, 0>, <1, 0, 0>, <2, 0, 0>, <3, 0, 0>, <0, 1, 0>, <1, 1, 1>, <2, 1, 1>, <3, 1, 0>,
  <0, 2, 0>, <1, 2, 1>, <2, 2, 1>, <3, 2, 0>, <0, 3, 0>, <1, 3, 0>, <2, 3, 0>, <3, 3, 0> }
blob { threshold 0.5 sphere { 0, 1, strength 2 pigment { rgb x } } cylinder { 0, x, 0.5, -1 scale 2 } sturm hierarchy off }
mesh { triangle { 0, x, y } smooth_triangle { 0, -z, x, -z, y, -z uv_vectors <0, 0>, <1, 0>, <0, 1> } inside_vector z }
mesh2 { vertex_vectors { 4, 0, x, y, x + y } normal_vectors { 1, -z } uv_vectors { 3, <0, 0>, <1, 0>, <0, 1> }
  texture_list { 1, texture { pigment { rgb z } } }
  face_indices { 2, <0, 1, 2>, 0, <1, 2, 3> } normal_indices { 2, <0, 0, 0>, <0, 0, 0> } uv_indices { 2, <0, 1, 2>, <0, 1, 2> } }
height_field { function 3, 2 { x * y } smooth water_level 0.25 }
julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 15 slice <0, 0, 0, 1>, 0.5 }
isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.5 } } threshold 0.5 accuracy 0.01 max_gradient 4 max_trace 2 open }
parametric { function { u }, function { v }, function { u * v } <0, 0>, <1, 1> contained_by { box { -1, 1 } } max_gradient 2 accuracy 0.01 }
text { ttf "timrom.ttf" "lute" 0.5, 0.1*x }
