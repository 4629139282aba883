// parametric: x, y and z from u and v; a saddle and a torus with precomputed bounds.
// lute scenes/feature/shape/parametric.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

parametric { function { u }, function { u * v * 0.6 }, function { v } <-1, -1>, <1, 1> contained_by { box { -1.1, 1.1 } } max_gradient 2 accuracy 0.02
  precompute 14 x, y, z rotate <-20, 30, 0> scale 0.9 translate -1.1 * x }
parametric { function { (0.6 + 0.25 * cos(v)) * cos(u) }, function { 0.25 * sin(v) }, function { (0.6 + 0.25 * cos(v)) * sin(u) }
  <0, 0>, <2 * pi, 2 * pi> contained_by { box { <-0.9, -0.3, -0.9>, <0.9, 0.3, 0.9> } } max_gradient 1.5 accuracy 0.02 precompute 15 x, y, z
  rotate -50 * x translate 1.1 * x }
