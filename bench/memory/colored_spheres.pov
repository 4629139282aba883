// A hundred thousand spheres, each with a pigment of its own; Count = 1 for what the program takes without them.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Count) #declare Count = 100000; #end
camera { location <0, 0, -3> look_at 0 }
light_source { <-2, 4, -3> rgb 1 }
#declare R = seed(1);
#for (I, 1, Count)
  sphere { <rand(R), rand(R), rand(R)> * 2 - 1, 0.01 pigment { rgb <rand(R), rand(R), rand(R)> } }
#end
