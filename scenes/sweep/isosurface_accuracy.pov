// A dented ball as an isosurface. Declare=Accuracy=0.1 … 1e-6: how near to the surface its roots are.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Accuracy) #declare Accuracy = 1e-6; #end
camera { location <0, 1.2, -4> look_at <0, 0, 0> right 4/3*x angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
background { rgb <0.5, 0.6, 0.75> }
isosurface {
  function { sqrt(x*x + y*y + z*z) - 1 + 0.08*sin(9*x)*sin(9*y)*sin(9*z) }
  accuracy Accuracy max_gradient 1.8
  contained_by { sphere { 0, 1.15 } }
  pigment { rgb <0.85, 0.55, 0.3> } finish { ambient 0.1 diffuse 0.75 phong 0.4 }
}
plane { y, -1.1 pigment { rgb 0.8 } }
