// A million triangles with normals and uv: 708 x 708 cells. Faces=0 leaves them out, for what the program takes without them.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Side) #declare Side = 708; #end
camera { location <0.5, 0.8, -1> look_at <0.5, 0, 0.5> }
light_source { <-2, 4, -3> rgb 1 }
#macro Height(X, Z) 0.05 * sin(20 * X) * cos(17 * Z) #end
mesh2 {
  vertex_vectors { (Side + 1) * (Side + 1)
    #for (I, 0, Side) #for (K, 0, Side) <I / Side, Height(I / Side, K / Side), K / Side> #end #end }
  normal_vectors { (Side + 1) * (Side + 1)
    #for (I, 0, Side) #for (K, 0, Side) <-cos(20 * I / Side) * cos(17 * K / Side), 1, 0.85 * sin(20 * I / Side) * sin(17 * K / Side)> #end #end }
  uv_vectors { (Side + 1) * (Side + 1) #for (I, 0, Side) #for (K, 0, Side) <I / Side, K / Side> #end #end }
  face_indices { 2 * Side * Side
    #for (I, 0, Side - 1) #for (K, 0, Side - 1)
      #local A = I * (Side + 1) + K;
      <A, A + 1, A + Side + 1> <A + 1, A + Side + 2, A + Side + 1>
    #end #end }
  uv_mapping pigment { checker rgb 1 rgb <0.2, 0.3, 0.6> scale 0.05 }
}
