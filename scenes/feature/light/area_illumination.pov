// area_illumination: every light of the grid shines from its own place.
// lute scenes/feature/light/area_illumination.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4 / 3 * x look_at <0, 0, 0> angle 40 }
#default { finish { ambient 0.05 diffuse 0.8 } }
plane { y, -1 pigment { rgb 0.9 } hollow }
sphere { <-1, -0.2, 0>, 0.7 pigment { rgb <1, 0.7, 0.5> } finish { phong 0.6 } }
box { <0.4, -1, -0.4>, <1.2, 0.3, 0.4> pigment { rgb <0.5, 0.9, 0.5> } rotate 20 * y }

light_source { <-2, 2, -2> rgb 1 area_light 3 * x, 3 * z, 5, 5 area_illumination on }
