// A torus from a slant: rays that graze the tube, pass the hole and leave and enter again, quartics with double and clustered roots.
#version 3.7;
#ifndef (Minor) #declare Minor = 0.3; #end
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 3, -4> direction <0, -0.6, 0.8> right 3*x up 2.25*<0, 0.8, 0.6> }
torus { 1, Minor pigment { rgb <1, 1, 0> } finish { ambient 1 diffuse 0 } }
background { rgb <0, 0, 1> }
