// A bent tube: cylinders with a ball at every joint.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z direction z right 4*x up 3*y }
sphere_sweep { linear_spline 5, <-1.4, -0.9, 0>, 0.25, <-0.7, 0.8, 0>, 0.25, <-0.6, -0.8, 0>, 0.25, <0.9, -0.8, 0>, 0.25, <1.2, 0.9, 0>, 0.25
  pigment { rgb <1, 1, 0> } finish { ambient 1 diffuse 0 } }
background { rgb <0, 0, 1> }
