// sphere_sweep, b_spline: near its spheres, not through them; with a tolerance.
// lute scenes/feature/shape/sphere_sweep_b_spline.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

sphere_sweep { b_spline 7, <-2.4, -1.4, 0>, 0.3, <-1.6, -0.6, 0>, 0.4, <-0.6, 1.3, 0>, 0.5, <0.2, -1.4, 0.3>, 0.3, <1, 1, -0.4>, 0.5,
  <1.8, -0.8, 0>, 0.2, <2.2, -1, 0>, 0.2 tolerance 0.001 }
