// Rays along z, parallel to four faces of a box, at its edge x = 1: the picture is 1.2e-12 wide.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Turned) #declare Turned = 0; #end
camera { orthographic location <1, 0.3, -3> direction z right 1.2e-12*x up 0.9*y
  #if (Turned) rotate 90*y #end }
box { -1, 1 pigment { rgb <1, 1, 0> } finish { ambient 1 diffuse 0 }  #if (Turned) rotate 90*y #end }
background { rgb <0, 0, 1> }
