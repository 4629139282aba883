// textures of CSG parts: a part without one has that of the whole, moved with it.
// lute scenes/feature/csg/textures.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

union {
  sphere { <-0.7, 0, 0>, 0.7 }
  sphere { <0.7, 0, 0>, 0.7 pigment { checker rgb <0.9, 0.2, 0.2>, rgb 1 scale 0.2 } rotate 20 * z }
  pigment { gradient x color_map { [0.5 rgb <0.3, 0.4, 1>] [0.5 rgb 1] } scale 0.3 }
  rotate <0, 20, -10>
}
