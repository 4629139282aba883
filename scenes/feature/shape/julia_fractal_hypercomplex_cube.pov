// julia_fractal, hypercomplex cubes (the squares are iterated, as in the reference).
// lute scenes/feature/shape/julia_fractal_hypercomplex_cube.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

julia_fractal { <-0.083, 0, -0.4, -0.025> hypercomplex cube max_iteration 4 precision 20 rotate 30 * y scale 0.8 }
