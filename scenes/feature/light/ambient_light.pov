// ambient_light multiplies every ambient.
// lute scenes/feature/light/ambient_light.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4 / 3 * x look_at <0, 0, 0> angle 40 }
#default { finish { ambient 0.05 diffuse 0.8 } }
plane { y, -1 pigment { rgb 0.9 } hollow }
sphere { <-1, -0.2, 0>, 0.7 pigment { rgb <1, 0.7, 0.5> } finish { phong 0.6 } }
box { <0.4, -1, -0.4>, <1.2, 0.3, 0.4> pigment { rgb <0.5, 0.9, 0.5> } rotate 20 * y }

global_settings { ambient_light rgb <4, 2, 8> }
light_source { <-4, 5, -4> rgb 0.4 }
