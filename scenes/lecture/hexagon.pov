// hexagon: a tiling of the x-z plane by three colours, constant along y.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.6, 0.7, 0.85> }
camera { location <0, 5, -7> look_at <0, 0, 0.3> angle 50 }
light_source { <-5, 9, -7> rgb 1 }
plane { y, 0 pigment { hexagon rgb <0.85, 0.8, 0.65>, rgb <0.45, 0.3, 0.25>, rgb <0.3, 0.45, 0.4> scale 0.7 } }
sphere { <-1.6, 1, 0>, 1 pigment { hexagon rgb <0.9, 0.3, 0.2>, rgb 0.9, rgb <0.2, 0.3, 0.8> scale 0.3 translate <0.01, 0, 0.02> } }
box { <0.6, 0, -0.8>, <2.2, 1.4, 0.8> pigment { hexagon rgb <0.9, 0.8, 0.3>, rgb <0.5, 0.6, 0.3>, rgb <0.3, 0.3, 0.35> rotate x * 90 scale 0.4 translate 0.011 } rotate y * -25 }
