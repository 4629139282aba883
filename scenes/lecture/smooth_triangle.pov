// Phong's interpolation of normals: at the barycentric point (u, v) the shading normal is the normalised
// (1 - u - v)·nA + u·nB + v·nC, while the geometry stays a flat triangle.
// An octahedron with the normals of its sphere, beside the same octahedron with flat faces.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.1, 0.12, 0.18> }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 40 }
light_source { <-6, 7, -8> rgb 1 }
#macro Face(A, B, C, Smooth)
  #if (Smooth)
    smooth_triangle { A, A, B, B, C, C }
  #else
    triangle { A, B, C }
  #end
#end
#macro Octahedron(Smooth)
  #for (I, 0, 7)
    Face(x * (1 - 2 * mod(I, 2)), y * (1 - 2 * mod(floor(I / 2), 2)), z * (1 - 2 * floor(I / 4)), Smooth)
  #end
#end
union {
  Octahedron(yes)
  pigment { rgb <0.9, 0.55, 0.25> } finish { phong 0.6 phong_size 30 } rotate <0, 30, 0> scale 1.5 translate <-1.6, 0, 0>
}
union {
  Octahedron(no)
  pigment { rgb <0.9, 0.55, 0.25> } finish { phong 0.6 phong_size 30 } rotate <0, 30, 0> scale 1.5 translate <1.6, 0, 0>
}
