// mesh2 with a texture for each face, and with one for each corner of a face.
// lute scenes/feature/shape/mesh2_textures.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

#declare Red = texture { pigment { rgb <1, 0.2, 0.1> } }
#declare Green = texture { pigment { rgb <0.2, 0.9, 0.2> } }
#declare Blue = texture { pigment { rgb <0.2, 0.3, 1> } }
mesh2 {
  vertex_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, 0, -1> }
  texture_list { 3, texture { Red } texture { Green } texture { Blue } }
  face_indices { 8, <0, 2, 5>, 0, <1, 2, 5>, 1, <0, 3, 5>, 2, <1, 3, 5>, <0, 2, 4>, 1, <1, 2, 4>, 2, <0, 3, 4>, 0, <1, 3, 4>, 1 }
  pigment { checker rgb 1, rgb 0 scale 0.3 }
  rotate <10, 25, 0> translate -1.1 * x
}
mesh2 {
  vertex_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, 0, -1> }
  normal_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, 0, -1> }
  texture_list { 3, texture { Red } texture { Green } texture { Blue } }
  face_indices { 8, <0, 2, 5>, 0, 1, 2, <1, 2, 5>, 2, 1, 0, <0, 3, 5>, 0, 1, 2, <1, 3, 5>, 2, 1, 0,
    <0, 2, 4>, 0, 1, 2, <1, 2, 4>, 2, 1, 0, <0, 3, 4>, 0, 1, 2, <1, 3, 4>, 2, 1, 0 }
  rotate <10, 25, 0> translate 1.1 * x
}
