// smooth_triangle: the normals of the corners, which need not be of unit length, are mixed over the face; seen from behind, with normals
// that disagree with the face, with two textures, and as parts of a union.
// lute scenes/feature/shape/smooth_triangle.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

smooth_triangle { <-1.9, -0.9, 0>, <-1, -0.6, -1>, <-0.1, -0.9, 0.4>, <1, -0.6, -1>, <-1, 0.3, 0.2>, <0, 5, -3> }
smooth_triangle { <0.3, -1, 0>, <0, 0, 1>, <1.9, -1, 0>, <0.7, 0, 0.7>, <1.1, 0.2, 0.2>, <0, 1, 1> }
smooth_triangle { <-1.7, 0.4, 0>, <-1, 1, -1>, <-0.3, 0.4, 0>, <1, 1, -1>, <-1, 1.2, 0>, <0, -1, -1>
  texture { pigment { checker rgb 1 rgb <0.8, 0.2, 0.2> scale 0.15 } } interior_texture { pigment { rgb <0.3, 0.4, 1> } } rotate -25 * y }
union {
  #for (I, 0, 5)
    smooth_triangle {
      <cos(I * pi / 3), 0, sin(I * pi / 3)>, <cos(I * pi / 3), 0.4, sin(I * pi / 3)>,
      <cos((I + 1) * pi / 3), 0, sin((I + 1) * pi / 3)>, <cos((I + 1) * pi / 3), 0.4, sin((I + 1) * pi / 3)>,
      <0, 1, 0>, y
    }
  #end
  scale 0.6 rotate -20 * x translate <1, 0.5, 0>
}
