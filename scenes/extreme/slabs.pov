// Rays with direction components of ±0 and far below the smallest normal number, through a box, a cylinder, a cone and planes, or
// Declare=Aside=1.5 past them. All of them are 1 unit wide to the side; the last one is a floor along which the rays run.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Tiny) #declare Tiny = 0; #end
#ifndef (Aside) #declare Aside = 0; #end
#ifndef (Nudge) #declare Nudge = 0; #end
camera { location <Aside + Nudge*1e-9, 0, -3> direction z right Tiny*x up -Tiny*y }
#ifndef (Solid) #declare Solid = 0; #end
#switch (Solid)
  #case (0) box { -1, 1 #break
  #case (1) cylinder { -z, z, 1 #break
  #case (2) cylinder { -x, x, 1 #break
  #case (3) cone { -z, 0.5, z, 1 #break
  #case (4) plane { -z, 1 #break
  #case (5) intersection { plane { x, 1 } plane { -x, 1 } plane { y, 1 } plane { -y, 1 } plane { -z, 1 } #break
  #case (6) superellipsoid { <0.5, 0.5> #break
  #case (7) plane { y, -1 #break
#end
  pigment { rgb <1, 1, 0> } finish { ambient 1 diffuse 0 }
}
background { rgb <0, 0, 1> }
