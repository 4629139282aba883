// sphere: a centre and a radius; and one that non-uniform scaling turns into an ellipsoid.
// lute scenes/feature/shape/sphere.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

sphere { <-1, 0, 0>, 0.9 }
sphere { 0, 0.9 scale <0.6, 1.2, 0.4> rotate <20, 30, 40> translate <1.1, 0, 0> }
