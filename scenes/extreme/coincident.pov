// Solids whose faces coincide: Declare=Way=N combines them so that the outside is that of one box, up to 8; one ball, 9; nothing, 10.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Way) #declare Way = 0; #end
camera { orthographic location -5*z direction z right 4*x up 3*y }
#declare B = box { -1, 1 }
object {
  #switch (Way)
  #case (0) object { B } #break
  #case (1) intersection { object { B } object { B } } #break
  #case (2) union { object { B } object { B } } #break
  #case (3) merge { object { B } box { -0.5, 0.5 } } #break
  #case (4) union { box { -1, <0, 1, 1> } box { <0, -1, -1>, 1 } } #break
  #case (5) merge { box { -1, <0, 1, 1> } box { <0, -1, -1>, 1 } } #break
  #case (6) difference { box { <-1, -1, -1>, <2, 1, 1> } box { <1, -1, -1>, <2, 1, 1> } box { <1, -2, -2>, <3, 2, 2> } } #break
  #case (7) intersection { object { B } plane { x, 1 } plane { y, 1 } plane { -z, 1 } } #break
  #case (8) difference { object { B } plane { x, -1 } plane { y, -1 } plane { z, -1 } } #break
  #case (9) merge { sphere { 0, 1 } sphere { 0, 1 } } #break
  #case (10) difference { sphere { 0, 1 } sphere { 0, 1 } } #break
  #end
  rotate <20, 30, 10>
  pigment { rgb <1, 1, 0> } finish { ambient 1 diffuse 0 }
}
background { rgb <0, 0, 1> }
