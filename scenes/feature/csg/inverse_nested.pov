// inverse of a difference is a merge of what it kept out; subtracted intersections and merges.
// lute scenes/feature/csg/inverse_nested.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

difference {
  sphere { 0, 1 }
  intersection { box { -0.6, 0.6 } plane { z, 0 } }
  difference { box { <0, 0, -2>, <2, 2, 2> } sphere { <0.6, 0.6, -0.6>, 0.5 } }
  merge { cylinder { -2 * x, 2 * x, 0.2 } cylinder { -2 * y, 2 * y, 0.2 } }
  rotate <-10, 30, 0>
}
