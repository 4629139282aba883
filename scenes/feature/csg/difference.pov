// difference: the first part without the others; cut surfaces have the texture of what cut them.
// lute scenes/feature/csg/difference.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

difference {
  box { -0.8, 0.8 }
  sphere { <0.8, 0.8, -0.8>, 0.7 pigment { rgb <1, 0.3, 0.2> } }
  cylinder { -2 * x, 2 * x, 0.4 pigment { rgb <0.3, 0.4, 1> } }
  torus { 0.6, 0.2 translate 0.8 * y pigment { rgb <0.3, 0.9, 0.4> } }
  rotate <-10, 30, 0>
}
