// An icosahedron of twenty planes, Size wide, before a camera that stands as much farther off.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Size) #declare Size = 1; #end
#declare Golden = (1 + sqrt(5))/2;
camera { orthographic location -5*Size*z direction z right 4*Size*x up 3*Size*y }
background { rgb <0, 0, 1> }
intersection {
  #for (I, -1, 1, 2)
    #for (J, -1, 1, 2)
      #for (K, -1, 1, 2) plane { <I, J, K>, 1 } #end
      plane { <0, I/Golden, J*Golden>, 1 }
      plane { <I/Golden, J*Golden, 0>, 1 }
      plane { <J*Golden, 0, I/Golden>, 1 }
    #end
  #end
  scale Size
  pigment { rgb <1, 1, 0> } finish { ambient 1 diffuse 0 }
}
