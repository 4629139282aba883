// A million copies of a mesh of 5,000 triangles; Count = 1 for what the program takes without them.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Count) #declare Count = 1000000; #end
camera { location <0, 0, -3> look_at 0 }
light_source { <-2, 4, -3> rgb 1 }
#declare Side = 50;
#declare Leaf = mesh2 {
  vertex_vectors { (Side + 1) * (Side + 1)
    #for (I, 0, Side) #for (K, 0, Side) <I / Side - 0.5, 0.3 * sin(6 * I / Side) * cos(7 * K / Side), K / Side - 0.5> #end #end }
  face_indices { 2 * Side * Side
    #for (I, 0, Side - 1) #for (K, 0, Side - 1)
      #local A = I * (Side + 1) + K;
      <A, A + 1, A + Side + 1> <A + 1, A + Side + 2, A + Side + 1>
    #end #end }
  pigment { rgb <0.4, 0.9, 0.3> }
}
#declare R = seed(1);
#for (I, 1, Count)
  object { Leaf scale 0.005 rotate 360 * <rand(R), rand(R), rand(R)> translate <rand(R), rand(R), rand(R)> * 2 - 1 }
#end
