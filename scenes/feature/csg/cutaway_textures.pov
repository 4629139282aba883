// cutaway_textures: a cut surface has the textures of what was cut.
// lute scenes/feature/csg/cutaway_textures.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

difference {
  union {
    sphere { <-0.4, 0, 0>, 0.9 pigment { rgb <1, 0.3, 0.2> } }
    sphere { <0.5, 0, 0>, 0.9 pigment { checker rgb 1, rgb <0.3, 0.4, 1> scale 0.25 } }
  }
  box { <-3, -3, -3>, <3, 3, 0> rotate 20 * y }
  cutaway_textures
}
