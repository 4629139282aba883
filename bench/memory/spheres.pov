// A hundred thousand spheres as objects of their own; Count = 1 for what the program takes without them.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Count) #declare Count = 100000; #end
camera { location <0, 0, -3> look_at 0 }
light_source { <-2, 4, -3> rgb 1 }
#declare Shade = texture { pigment { rgb <1, 0.7, 0.3> } finish { ambient 0.1 } }
#declare R = seed(1);
#for (I, 1, Count)
  sphere { <rand(R), rand(R), rand(R)> * 2 - 1, 0.01 texture { Shade } }
#end
