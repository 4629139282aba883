// A torus along its axis, around the tube at (1, 0): Declare=Minor=1e-6 is a wire, 1 closes the hole to a point.
#version 3.7;
#ifndef (Minor) #declare Minor = 1e-6; #end
global_settings { assumed_gamma 1 }
camera { orthographic location <1, 3, 0> direction -y right 4*Minor*x up 3*Minor*z }
torus { 1, Minor pigment { rgb <1, 1, 0> } finish { ambient 1 diffuse 0 } }
background { rgb <0, 0, 1> }
