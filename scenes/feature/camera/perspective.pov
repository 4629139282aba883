// perspective: the default; the length of direction against right and up is the angle.
// lute scenes/feature/camera/perspective.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.7 } }

camera { location <0, 1, -6> right 4 / 3 * x up y direction 1.2 * z look_at <0, 0, 0.5> }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.7> } }
sphere { <-1, 0, 0>, 0.8 pigment { rgb <1, 0.4, 0.3> } }
box { <0.3, -0.9, -0.4>, <1.5, 0.4, 0.6> pigment { rgb <0.4, 0.9, 0.4> } rotate 15 * y }
cone { <0, -0.9, 2>, 0.7, <0, 1.2, 2>, 0 pigment { rgb <1, 0.9, 0.3> } }
