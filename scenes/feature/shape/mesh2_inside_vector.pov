// mesh2 with inside_vector: a solid, so that CSG can cut it.
// lute scenes/feature/shape/mesh2_inside_vector.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

#declare Cube = mesh2 {
  vertex_vectors { 8, <-1, -1, -1>, <1, -1, -1>, <1, 1, -1>, <-1, 1, -1>, <-1, -1, 1>, <1, -1, 1>, <1, 1, 1>, <-1, 1, 1> }
  face_indices { 12, <0, 2, 1>, <0, 3, 2>, <4, 5, 6>, <4, 6, 7>, <0, 1, 5>, <0, 5, 4>, <3, 6, 2>, <3, 7, 6>, <0, 4, 7>, <0, 7, 3>,
    <1, 2, 6>, <1, 6, 5> }
  inside_vector <0.3, 0.2, 1>
}
difference { object { Cube } sphere { <0, 0, -1>, 0.9 } rotate <20, 30, 0> scale 0.6 translate -1 * x }
intersection { object { Cube rotate <20, 40, 10> } sphere { 0, 1.25 } scale 0.6 translate 1 * x }
