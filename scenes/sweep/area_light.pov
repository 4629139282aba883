// Soft shadows. Declare=Lamps=2 … 9: an area light of Lamps × Lamps lamps.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Lamps) #declare Lamps = 9; #end
camera { location <0, 3, -7> look_at <0, 0.6, 0> right 4/3*x angle 40 }
light_source { <-4, 6, -4>, rgb 1 area_light <2, 0, 0>, <0, 0, 2>, Lamps, Lamps }
background { rgb <0.5, 0.6, 0.75> }
sphere { <-1, 0.8, 0>, 0.8 pigment { rgb <0.8, 0.35, 0.25> } }
box { <0.4, 0, -0.6>, <1.6, 1.4, 0.4> pigment { rgb <0.3, 0.5, 0.75> } rotate 10*y }
plane { y, 0 pigment { rgb 0.85 } }
