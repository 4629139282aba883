// prism, bezier_spline: four points a piece; with sturm.
// lute scenes/feature/shape/prism_bezier.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

prism { linear_sweep bezier_spline -0.4, 0.4, 12, <-1, 0>, <-1, -0.8>, <-0.4, -1>, <0.2, -0.6>, <0.2, -0.6>, <0.6, -1>, <1.3, -0.6>, <1, 0.2>,
  <1, 0.2>, <0.5, 1.2>, <-0.9, 1>, <-1, 0> sturm rotate <-50, 20, 0> }
