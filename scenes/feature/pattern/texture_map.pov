// texture_map: two lit textures, blended.
// lute scenes/feature/pattern/texture_map.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane {
  z, 0
  texture {
    gradient x
    texture_map {
      [0.2 pigment { rgb <0.8, 0.2, 0.1> } normal { bumps 0.8 scale 0.1 } finish { phong 0.8 }]
      [0.8 pigment { granite color_map { [0 rgb 0] [1 rgb 1] } }]
    }
    scale 4
    translate -2*x
    turbulence 0.2
  }
}
