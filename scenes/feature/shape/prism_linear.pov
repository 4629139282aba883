// prism, linear_spline: an outline in x and z, swept along y; one that cuts itself; open ends.
// lute scenes/feature/shape/prism_linear.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

prism { linear_sweep linear_spline -0.4, 0.4, 6, <-0.6, -0.6>, <0.6, -0.6>, <0.8, 0.3>, <0, 0.9>, <-0.8, 0.3>, <-0.6, -0.6>
  rotate <-50, 20, 0> translate <-1.3, 0, 0> }
prism { -0.3, 0.3, 6, <0, 0.8>, <0.47, -0.65>, <-0.76, 0.25>, <0.76, 0.25>, <-0.47, -0.65>, <0, 0.8> rotate -60 * x translate <0.4, 0, 0> }
prism { -0.5, 0.5, 5, <-0.4, -0.4>, <0.4, -0.4>, <0.4, 0.4>, <-0.4, 0.4>, <-0.4, -0.4> open
  texture { pigment { rgb <1, 0.8, 0.5> } } interior_texture { pigment { rgb <0.3, 0.4, 1> } } rotate <-40, 30, 0> translate <1.6, 0, 0> }
