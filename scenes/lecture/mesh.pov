// A mesh: many triangles as one object, one bounding hierarchy. Faces with and without normals of their own, a texture of a
// face, and inside_vector, which makes a closed mesh a solid (count the crossings of a ray in that direction).
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.12, 0.15, 0.2> }
camera { location <0, 3, -8> look_at <0, 0.3, 0> angle 42 }
light_source { <-5, 9, -7> rgb 1 }
#declare Height = function(X, Z) { 0.5 * sin(2.2 * X) * cos(1.7 * Z) }
#declare N = 16;
#declare Red = texture { pigment { rgb <0.85, 0.25, 0.2> } finish { phong 0.4 } }
mesh {
  #for (I, 0, N - 1)
    #for (J, 0, N - 1)
      #declare X0 = -2.4 + 4.8 * I / N; #declare X1 = X0 + 4.8 / N;
      #declare Z0 = -2.4 + 4.8 * J / N; #declare Z1 = Z0 + 4.8 / N;
      triangle { <X0, Height(X0, Z0), Z0>, <X1, Height(X1, Z0), Z0>, <X1, Height(X1, Z1), Z1>
        #if (mod(I + J, 5) = 0) texture { Red } #end }
      triangle { <X0, Height(X0, Z0), Z0>, <X1, Height(X1, Z1), Z1>, <X0, Height(X0, Z1), Z1> }
    #end
  #end
  texture { pigment { rgb <0.35, 0.6, 0.75> } finish { diffuse 0.8 } }
  rotate y * 25
}
#declare Tetra = mesh {
  triangle { <1, 1, 1>, <-1, -1, 1>, <-1, 1, -1> }
  triangle { <1, 1, 1>, <1, -1, -1>, <-1, -1, 1> }
  triangle { <1, 1, 1>, <-1, 1, -1>, <1, -1, -1> }
  triangle { <-1, -1, 1>, <1, -1, -1>, <-1, 1, -1> }
  inside_vector <0.1, 1, 0.2>
}
difference {
  object { Tetra }
  sphere { 0, 0.8 }
  pigment { rgb <0.9, 0.8, 0.4> } scale 0.8 rotate <20, 30, 0> translate <0, 1.6, -0.5>
}
