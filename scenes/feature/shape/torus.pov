// torus: major and minor radius, about y; thin, thick and squeezed.
// lute scenes/feature/shape/torus.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

torus { 0.7, 0.2 rotate -50 * x translate <-1.1, 0, 0> }
torus { 0.5, 0.35 rotate <30, 0, 40> scale <1, 0.7, 1> translate <0.8, 0.3, 0> }
torus { 0.6, 0.02 sturm rotate -70 * x translate <1.2, -0.6, 0> }
