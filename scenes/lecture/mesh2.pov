// mesh2: lists of vertices, normals, textures and faces (three indices each). A normal for each vertex in the same order makes
// every face smooth; normal_indices name others; texture_list with indices per face, and per vertex (blended).
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.15, 0.12, 0.18> }
camera { location <0, 2.5, -9> look_at <0, 0, 0> angle 40 }
light_source { <-6, 8, -8> rgb 1 }
#declare Warm = texture { pigment { rgb <0.95, 0.5, 0.2> } finish { phong 0.5 } }
#declare Cold = texture { pigment { rgb <0.2, 0.5, 0.95> } finish { phong 0.5 } }
#declare White = texture { pigment { rgb 0.9 } finish { phong 0.5 } }
// A smooth octahedron with textures per vertex.
mesh2 {
  vertex_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, 0, -1> }
  normal_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, 0, -1> }
  texture_list { 3, texture { Warm } texture { Cold } texture { White } }
  face_indices { 8,
    <0, 2, 5>, 0, 1, 2, <1, 2, 5>, 2, 1, 0, <0, 3, 5>, 0, 1, 2, <1, 3, 5>, 2, 1, 0,
    <0, 2, 4>, 0, 1, 2, <1, 2, 4>, 2, 1, 0, <0, 3, 4>, 0, 1, 2, <1, 3, 4>, 2, 1, 0 }
  rotate <0, 25, 0> scale 1.4 translate <-2.2, 0.2, 0>
}
// Flat faces, a texture for each.
mesh2 {
  vertex_vectors { 5, <-1, -0.8, -1>, <1, -0.8, -1>, <1, -0.8, 1>, <-1, -0.8, 1>, <0, 1.2, 0> }
  texture_list { 2, texture { Warm } texture { Cold } }
  face_indices { 6, <0, 1, 4>, 0, <1, 2, 4>, 1, <2, 3, 4>, 0, <3, 0, 4>, 1, <0, 1, 2>, 0, <0, 2, 3>, 0 }
  rotate y * 35 translate <0.6, 0, 0>
}
// One texture, normals by their own indices.
mesh2 {
  vertex_vectors { 4, <-1, -1, 0>, <1, -1, 0>, <1, 1, 0>, <-1, 1, 0> }
  normal_vectors { 3, <0, 0, -1>, <0.7, 0, -0.7>, <-0.7, 0.3, -0.7> }
  face_indices { 2, <0, 1, 2>, <0, 2, 3> }
  normal_indices { 2, <2, 1, 0>, <2, 0, 1> }
  texture { White }
  rotate y * 15 translate <3, 0.2, 0>
}
plane { y, -1.3 pigment { rgb <0.4, 0.4, 0.45> } }
