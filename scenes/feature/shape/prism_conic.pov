// prism, conic_sweep: the outline grows with the height; linear, bezier, and one with both signs of height.
// lute scenes/feature/shape/prism_conic.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

prism { conic_sweep linear_spline 0.3, 1, 5, <-0.6, -0.6>, <0.6, -0.6>, <0.8, 0.5>, <-0.6, 0.6>, <-0.6, -0.6> rotate <160, 20, 0> translate <-1.4, 0.6, 0> }
prism { conic_sweep bezier_spline 0, 1, 8, <-0.6, 0>, <-0.6, -0.9>, <0.6, -0.9>, <0.6, 0>, <0.6, 0>, <0.6, 0.4>, <-0.6, 0.4>, <-0.6, 0>
  rotate 170 * x translate <0, 0.6, 0> }
prism { conic_sweep linear_spline -0.7, 0.7, 4, <-0.8, -0.6>, <0.8, -0.6>, <0, 0.9>, <-0.8, -0.6> rotate <20, 20, 10> translate <1.4, 0, 0> }
