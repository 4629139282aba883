// A floor seen from a millionth of a unit above it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1e-6, 0> direction z right 4/3*x up y }
plane { y, 0
  pigment { function { mod(floor(z*1e6 + 0.3), 2) } color_map { [0.5 rgb <0, 0.5, 0>] [0.5 rgb <1, 1, 0>] } }
  finish { ambient 1 diffuse 0 }
}
background { rgb <0, 0, 1> }
