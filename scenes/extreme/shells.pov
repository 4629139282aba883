// Two hundred clear shells, one in the other: up to four hundred surfaces on a ray.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 256 adc_bailout 0 }
camera { orthographic location -5*z direction z right 4*x up 3*y }
#for (I, 1, 200)
  sphere { 0, 1 + I/200 pigment { rgbt <0, 0, 0, 0.996> } finish { ambient 1 diffuse 0 } }
#end
background { rgb 1 }
