// sphere_sweep, linear_spline: cones between spheres.
// lute scenes/feature/shape/sphere_sweep_linear.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

sphere_sweep { linear_spline 5, <-1.5, -0.8, 0>, 0.3, <-0.6, 0.8, 0>, 0.5, <0.2, -0.7, 0.3>, 0.2, <1, 0.6, -0.4>, 0.4, <1.6, -0.6, 0>, 0.1 }
