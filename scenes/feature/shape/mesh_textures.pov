// mesh whose triangles have their own textures, uv_vectors and texture_list.
// lute scenes/feature/shape/mesh_textures.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

#declare Red = texture { pigment { rgb <1, 0.2, 0.1> } }
#declare Green = texture { pigment { rgb <0.2, 0.9, 0.2> } }
#declare Blue = texture { pigment { rgb <0.2, 0.3, 1> } finish { specular 0.6 } }
mesh {
  triangle { <-2, -0.9, 0>, <-0.6, -0.9, 0>, <-1.3, 0.9, 0.3> texture { Red } }
  triangle { <-0.6, -0.9, 0>, <0.8, -0.9, 0>, <0, 0.9, -0.3> texture_list { Red, Green, Blue } }
  triangle { <0.8, -0.9, 0>, <2, -0.9, 0>, <1.4, 0.9, 0.3> uv_vectors <0, 0>, <1, 0>, <0.5, 1> }
  pigment { uv_mapping checker rgb 1, rgb 0.3 scale 0.25 }
}
