// mesh: triangles and smooth triangles together; a wavy sheet of 2 x 12 x 12.
// lute scenes/feature/shape/mesh.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

#macro Height(X, Z) (0.25 * sin(4 * X) * cos(3 * Z)) #end
#macro Point(X, Z) <X, Height(X, Z), Z> #end
#macro Normal(X, Z) <-cos(4 * X) * cos(3 * Z), 1, 0.75 * sin(4 * X) * sin(3 * Z)> #end
#declare S = 2.4 / 12;
mesh {
  #for (I, 0, 11)
    #for (K, 0, 11)
      #local X = -1.2 + I * S;
      #local Z = -1.2 + K * S;
      smooth_triangle { Point(X, Z), Normal(X, Z), Point(X + S, Z), Normal(X + S, Z), Point(X, Z + S), Normal(X, Z + S) }
      #if (mod(I + K, 3) > 0)
        triangle { Point(X + S, Z + S), Point(X + S, Z), Point(X, Z + S) }
      #end
    #end
  #end
  rotate <-30, 25, 0>
}
