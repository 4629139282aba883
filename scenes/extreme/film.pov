// A clear box a ten-millionth of a unit above a floor.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 20 }
#ifndef (Gap) #declare Gap = 1e-7; #end
camera { location <0, 2, -3> direction <0, -2, 3> right 4/3*2*x up 2*vnormalize(<0, 3, 2>) }
plane { y, 0 pigment { rgb <0, 1, 0> } finish { ambient 1 diffuse 0 } }
box { <-1, Gap, -1>, <1, 0.3, 1> pigment { rgbt <1, 0, 0, 0.5> } finish { ambient 1 diffuse 0 } }
background { rgb <0, 0, 1> }
