// material_map: an image chooses among textures.
// lute scenes/feature/pattern/material_map.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane {
  z, 0
  texture {
    material_map { function 16, 16 { floor(x*3)/255 } texture { pigment { rgb <0.8, 0.2, 0.1> } } texture { pigment { checker scale 0.1 } } texture { pigment { rgb 0.9 } finish { phong 1 } } }
    scale 2
  }
}
