// height_field in CSG: it is a solid down without limit, so a box bounds it.
// lute scenes/feature/shape/height_field_csg.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

intersection {
  height_field { function 33, 33 { 0.5 + 0.4 * sin(x * 9) * cos(y * 7) } smooth translate <-0.5, 0, -0.5> scale <2.4, 0.8, 2.4> }
  cylinder { -0.2 * y, 2 * y, 1.1 }
  rotate <-20, 20, 0>
}
