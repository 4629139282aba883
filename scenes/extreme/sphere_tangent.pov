// The rim of a unit sphere under a magnification of a thousand million: 4e-9 by 1.2e-4 units around (1, 0).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <1, 0, -3> direction z right 4e-9*x up 1.2e-4*y }
sphere { 0, 1 pigment { rgb <1, 1, 0> } finish { ambient 1 diffuse 0 } }
background { rgb <0, 0, 1> }
