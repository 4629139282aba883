// polygon: an outline in a plane; further outlines are holes; one that cuts itself is filled by even and odd.
// lute scenes/feature/shape/polygon.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

polygon { 12, <-0.8, -0.8>, <0.8, -0.8>, <0.9, 0.5>, <0, 1>, <-0.8, 0.6>, <-0.8, -0.8>,
  <-0.4, -0.4>, <0.4, -0.4>, <0.4, 0.3>, <0, 0.5>, <-0.4, 0.3>, <-0.4, -0.4> rotate <20, 30, 0> translate -1 * x }
polygon { 6, <0, 0.9>, <0.53, -0.73>, <-0.86, 0.28>, <0.86, 0.28>, <-0.53, -0.73>, <0, 0.9> rotate <0, -30, 20> translate 1.1 * x
  texture { pigment { rgb <1, 0.8, 0.5> } } interior_texture { pigment { rgb <0.3, 0.4, 1> } } }
