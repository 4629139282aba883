// parametric with uv_mapping: the pattern is in u and v.
// lute scenes/feature/shape/parametric_uv.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

parametric { function { sin(u) * cos(v) }, function { sin(u) * sin(v) }, function { cos(u) } <0, 0>, <pi, 2 * pi>
  contained_by { sphere { 0, 1.1 } } max_gradient 1.5 accuracy 0.005 precompute 15 x, y, z
  uv_mapping pigment { checker rgb 1, rgb <0.8, 0.2, 0.1> scale 0.3 } rotate 40 * x }
