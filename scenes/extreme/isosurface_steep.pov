// A ball as the zero of functions that are hard to follow: Declare=Kind=0 a gradient of two million, 1 a pole at the centre,
// 2 a pole outside of the ball, 3 flat at the surface (a triple zero).
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Kind) #declare Kind = 0; #end
camera { orthographic location -5*z direction z right 4*x up 3*y }
isosurface {
  #switch (Kind)
  #case (0) function { 1e6*(x*x + y*y + z*z - 1) } max_gradient 4e6 accuracy 1e-6 #break
  #case (1) function { 1 - 1/(x*x + y*y + z*z) } max_gradient 20 accuracy 1e-6 #break
  #case (2) function { (x*x + y*y + z*z - 1)/abs(1.5 - sqrt(x*x + y*y + z*z)) } max_gradient 600 accuracy 1e-6 #break
  #case (3) function { pow(x*x + y*y + z*z - 1, 3) } max_gradient 60 accuracy 1e-4 #break
  #end
  contained_by { sphere { 0, 1.45 } }
  pigment { rgb <1, 1, 0> } finish { ambient 1 diffuse 0 }
}
background { rgb <0, 0, 1> }
