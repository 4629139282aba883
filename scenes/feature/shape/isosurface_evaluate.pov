// isosurface that watches its max_gradient as it goes.
// lute scenes/feature/shape/isosurface_evaluate.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

isosurface { function { pow(x, 4) + pow(y, 4) + pow(z, 4) - 0.8 } max_gradient 6 evaluate 6, 1, 0.99 contained_by { box { -1.1, 1.1 } } rotate <10, 30, 0> }
