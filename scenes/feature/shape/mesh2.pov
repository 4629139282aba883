// mesh2: vertices and faces in lists; normals for each vertex, and by their own indices.
// lute scenes/feature/shape/mesh2.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

mesh2 {
  vertex_vectors { 8, <-1, -1, -1>, <1, -1, -1>, <1, 1, -1>, <-1, 1, -1>, <-1, -1, 1>, <1, -1, 1>, <1, 1, 1>, <-1, 1, 1> }
  face_indices { 12, <0, 2, 1>, <0, 3, 2>, <4, 5, 6>, <4, 6, 7>, <0, 1, 5>, <0, 5, 4>, <3, 6, 2>, <3, 7, 6>, <0, 4, 7>, <0, 7, 3>,
    <1, 2, 6>, <1, 6, 5> }
  rotate <20, 30, 0> scale 0.55 translate <-1.3, 0, 0>
}
mesh2 {
  vertex_vectors { 8, <-1, -1, -1>, <1, -1, -1>, <1, 1, -1>, <-1, 1, -1>, <-1, -1, 1>, <1, -1, 1>, <1, 1, 1>, <-1, 1, 1> }
  normal_vectors { 8, <-1, -1, -1>, <1, -1, -1>, <1, 1, -1>, <-1, 1, -1>, <-1, -1, 1>, <1, -1, 1>, <1, 1, 1>, <-1, 1, 1> }
  face_indices { 12, <0, 2, 1>, <0, 3, 2>, <4, 5, 6>, <4, 6, 7>, <0, 1, 5>, <0, 5, 4>, <3, 6, 2>, <3, 7, 6>, <0, 4, 7>, <0, 7, 3>,
    <1, 2, 6>, <1, 6, 5> }
  rotate <20, 30, 0> scale 0.55 translate <0.3, 0, 0>
}
mesh2 {
  vertex_vectors { 5, <-0.5, -0.8, -0.5>, <0.5, -0.8, -0.5>, <0.5, -0.8, 0.5>, <-0.5, -0.8, 0.5>, <0, 0.8, 0> }
  normal_vectors { 4, <-1, 0.3, -1>, <1, 0.3, -1>, <0, 1, -1>, <1, 0.3, 1> }
  face_indices { 4, <0, 4, 1>, <1, 4, 2>, <2, 4, 3>, <3, 4, 0> }
  normal_indices { 2, <0, 2, 1>, <1, 2, 3> }
  rotate <0, 35, 0> translate <1.7, 0, 0>
}
