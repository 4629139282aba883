// poly and polynomial: orders 2, 5, 6 and 8.
// lute scenes/feature/shape/poly.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

poly { 2, <1, 0, 0, 0, 1.5, 0, 0, 4, 0, -0.3> translate <-1.5, 0.6, 0> }
polynomial { 6, xyz(6, 0, 0): 1, xyz(0, 6, 0): 1, xyz(0, 0, 6): 1, xyz(0, 0, 0): -0.03 rotate <20, 30, 0> translate <0, 0.6, 0> }
polynomial { 8, xyz(8, 0, 0): 1, xyz(0, 4, 0): 1, xyz(0, 0, 8): 1, xyz(2, 2, 2): -3, xyz(0, 0, 0): -0.01 sturm
  rotate <20, -30, 0> translate <1.5, 0.6, 0> }
polynomial { 5, xyz(5, 0, 0): 1, xyz(0, 2, 0): 1, xyz(0, 0, 2): 1, xyz(1, 0, 0): -1 clipped_by { sphere { 0, 1.2 } }
  scale 0.7 rotate 20 * y translate <0, -0.8, 0> }
