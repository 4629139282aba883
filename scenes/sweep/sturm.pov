// Shapes of fourth order with nearly double roots. Declare=Sturm=1: their equations are solved by Sturm chains.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Sturm) #declare Sturm = 1; #end
camera { location <0, 2.2, -5> look_at 0 right 4/3*x angle 42 }
light_source { <-4, 6, -5>, rgb 1 }
background { rgb <0.5, 0.6, 0.75> }
#default { finish { ambient 0.15 diffuse 0.7 } }
torus { 1.2, 0.02 #if (Sturm) sturm #end rotate 20*x pigment { rgb <0.85, 0.7, 0.2> } }
// A lemniscate, whose leaves meet in a point.
quartic { <1, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0>
  #if (Sturm) sturm #end rotate 30*y translate <0, -0.1, 0.3> pigment { rgb <0.3, 0.5, 0.8> } bounded_by { sphere { 0, 1.2 } } }
blob { threshold 0.6 sphere { <-1.4, 0.6, 0.6>, 0.9, 1 } sphere { <-0.5, 0.75, 0.8>, 0.8, 1 } #if (Sturm) sturm #end
  pigment { rgb <0.75, 0.3, 0.3> } }
plane { y, -1 pigment { rgb 0.8 } }
