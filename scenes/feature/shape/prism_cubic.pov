// prism, cubic_spline: smooth outlines with a control point before and after; two of them.
// lute scenes/feature/shape/prism_cubic.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

prism { linear_sweep cubic_spline -0.4, 0.4, 16, <-1.2, 0.6>, <-1, -0.8>, <0.2, -1.1>, <1.1, -0.6>, <0.8, 0.8>, <-0.9, 0.9>, <-1, -0.8>, <0.2, -1.1>,
  <-0.4, 0.4>, <-0.4, -0.4>, <0, -0.6>, <0.4, -0.4>, <0.4, 0.4>, <-0.4, 0.4>, <-0.4, -0.4>, <0, -0.6>
  rotate <-50, 20, 0> }
