// julia_fractal, hypercomplex ln.
// lute scenes/feature/shape/julia_fractal_hypercomplex_ln.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

#declare Set = julia_fractal { <0.2, 0.4, 0.1, 0.1> hypercomplex ln max_iteration 3 precision 20 }
intersection { object { Set } sphere { 0, 3 } box { <-4, -4, -4>, <4, 4, 0> rotate 20 * y inverse } no_shadow scale 0.42 }
