// cubic: x³ + y³ + z³ - 0.6 x y + 0.2 x - 0.1, twenty coefficients, cut by a sphere.
// lute scenes/feature/shape/cubic.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

cubic { <1, 0, 0, 0, 0, 0, -0.6, 0, 0, 0.2, 1, 0, 0, 0, 0, 0, 1, 0, 0, -0.1>
  clipped_by { sphere { 0, 1.4 } } rotate <-20, 30, 0> }
