// blob whose components have textures: they are mixed by density.
// lute scenes/feature/shape/blob_textures.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

blob {
  threshold 0.5
  sphere { <-0.8, 0, 0>, 1.2, 1 pigment { rgb <1, 0.2, 0.1> } }
  sphere { <0.6, 0.3, 0>, 1.2, 1 pigment { rgb <0.2, 0.3, 1> } }
  cylinder { <-0.6, -0.9, 0>, <1.2, -0.7, 0>, 0.5, 1 pigment { checker rgb 1, rgb 0 scale 0.2 } }
  sphere { <0, 0.9, 0>, 0.9, 0.8 }
  pigment { rgb <0.9, 0.9, 0.2> }
}
