// Hills, flattened together with the camera: an affine map of everything, so the picture stays.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Flat) #declare Flat = 1; #end
#declare Squeeze = transform { scale <1, Flat, 1> }
camera { location <0, 2, -2.5> direction <0, -1.2, 1.6> right 4/3*1.2*x up 1.2*<0, 0.8, 0.6> transform Squeeze }
height_field { function 40, 40 { 0.5 + 0.4*sin(9*x)*cos(7*y) }
  translate <-0.5, 0, -0.5> scale <2.4, 1, 2.4>
  pigment { function { mod(floor(6*x) + floor(6*z) + floor(12*y) + 100, 2) } color_map { [0.5 rgb <0, 0.5, 0>] [0.5 rgb <1, 1, 0>] } }
  finish { ambient 1 diffuse 0 }
  transform Squeeze }
background { rgb <0, 0, 1> }
