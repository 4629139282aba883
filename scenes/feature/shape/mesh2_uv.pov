// mesh2 with uv_vectors and uv_indices.
// lute scenes/feature/shape/mesh2_uv.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

mesh2 {
  vertex_vectors { 5, <-1, -0.8, -1>, <1, -0.8, -1>, <1, -0.8, 1>, <-1, -0.8, 1>, <0, 1.1, 0> }
  uv_vectors { 4, <0, 0>, <1, 0>, <0.5, 1>, <0.2, 0.7> }
  face_indices { 4, <0, 1, 4>, <1, 2, 4>, <2, 3, 4>, <3, 0, 4> }
  uv_indices { 4, <0, 1, 2>, <1, 3, 2>, <0, 1, 3>, <3, 0, 2> }
  uv_mapping pigment { checker rgb 1, rgb <0.8, 0.2, 0.1> scale 0.15 }
  rotate 35 * y
}
