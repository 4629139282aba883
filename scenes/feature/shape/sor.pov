// sor: a surface of revolution through points, with caps and open.
// lute scenes/feature/shape/sor.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

#declare Points = sor { 7, <0, -1.2>, <0.5, -0.9>, <0.7, -0.4>, <0.25, 0.2>, <0.4, 0.7>, <0.45, 0.9>, <0.4, 1> }
object { Points translate -0.9 * x }
sor { 7, <0, -1.2>, <0.5, -0.9>, <0.7, -0.4>, <0.25, 0.2>, <0.4, 0.7>, <0.45, 0.9>, <0.4, 1> open
  texture { pigment { rgb <1, 0.8, 0.5> } } interior_texture { pigment { rgb <0.3, 0.4, 1> } } rotate <-60, 0, 20> translate <1, 0.2, 0> }
