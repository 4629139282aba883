// A ray that hits nothing takes the background colour; so do reflected and refracted rays, which carry it into the picture.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.85, 0.55, 0.25> }
camera { location <0, 0, -5> look_at 0 angle 45 }
light_source { <-4, 6, -6> rgb 1 }
sphere { <-1.1, 0, 0>, 1 pigment { rgb <0.1, 0.1, 0.12> } finish { reflection 0.7 } }
sphere { <1.1, 0, 0>, 1 pigment { rgbf <0.8, 1, 0.9, 0.9> } interior { ior 1.3 } finish { specular 0.6 } }
