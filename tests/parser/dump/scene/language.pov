// What directives make of a scene: nothing of them is left in it.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Count = 3;
#local Sizes = array[3] { 0.5, 1, 1.5 };
#macro Ball(Place, Size)
  sphere { Place, Size #if (Size > 1) pigment { rgb x } #else pigment { rgb z } #end }
#end
#for (I, 0, Count - 1)
  Ball(I * x, Sizes[I])
#end
#declare I = 0;
#while (I < 2)
  box { I, I + 1 translate <I, sin(I), pow(2, I)> }
  #declare I = I + 1;
#end
#switch (Count)
  #case (1) torus { 1, 0.5 } #break
  #range (2, 4) cone { 0, 1, y, 0 } #break
  #else plane { y, 0 }
#end
#ifdef (Sizes) #undef Sizes #end
#ifndef (Sizes) disc { 0, y, Count } #end
#declare Thing = union { sphere { 0, 1 } box { 0, 1 } texture { pigment { rgb 1 } } };
object { Thing rotate 45*y }
#declare Path = spline { cubic_spline -1, x, 0, y, 1, z, 2, 0 };
sphere { Path(0.5), vlength(Path(0.25)) }
#declare F = function(x, y) { x * x + y };
cylinder { 0, <F(1, 2), strlen("text"), val("2.5")>, 0.1 }
