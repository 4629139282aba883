// A point light: irradiance by Lambert's law, I = kd · max(0, n·L) · light, with L the direction to the light; with fade_distance d0
// and fade_power p the light is multiplied by 2 / (1 + (d / d0)^p).
// Three lights of different colour, two of them fading.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -8> look_at <0, 0.5, 0> angle 50 }
light_source { <-3, 3, -2> rgb <1, 0.45, 0.35> fade_distance 3 fade_power 2 }
light_source { <3, 2, -3> rgb <0.4, 0.6, 1> fade_distance 2 fade_power 1 }
light_source { <0, 8, 4> rgb <0.3, 0.3, 0.25> }
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0.05 diffuse 0.8 } }
sphere { <0, 1, 0>, 1 pigment { rgb <0.9, 0.9, 0.85> } finish { ambient 0.05 diffuse 0.8 } }
sphere { <-2.4, 0.6, 1>, 0.6 pigment { rgb 0.9 } finish { ambient 0.05 diffuse 0.8 brilliance 3 } }
