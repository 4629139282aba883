// isosurface in CSG, with all_intersections and with max_trace.
// lute scenes/feature/shape/isosurface_max_trace.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

difference {
  isosurface { function { abs(sqrt(x * x + y * y + z * z) - 0.8) - 0.1 } max_gradient 1.2 all_intersections contained_by { box { -1, 1 } } }
  box { <-2, -2, -2>, <2, 2, 0> rotate -30 * y }
  translate -1.1 * x
}
difference {
  isosurface { function { abs(sqrt(x * x + y * y) - 0.6) - 0.15 } max_gradient 1.2 max_trace 4 contained_by { box { -1, 1 } } }
  box { <-2, 0, -2>, <2, 2, 2> rotate 20 * z }
  rotate -20 * x translate 1.1 * x
}
