// A planet of radius 6.4e6 m, seen from 1 m above the ground through a lens of half a degree: bands of 100 m up to the horizon.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, 0> direction z right 4/3*0.008*x up 0.008*y }
sphere { <0, -6.4e6, 0>, 6.4e6
  pigment { function { mod(floor(z/100), 2) } color_map { [0.5 rgb <0, 0.5, 0>] [0.5 rgb <1, 1, 0>] } }
  finish { ambient 1 diffuse 0 }
}
background { rgb <0, 0, 1> }
