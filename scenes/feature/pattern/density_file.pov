// density_file: a df3 volume, here the smallest one that shows interpolation (3 by 1 by 1 voxels).
// lute scenes/feature/pattern/density_file.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

box {
  <0, 0, 0>, <1, 1, 0.5>
  pigment { density_file df3 "steps.df3" interpolate 1 color_map { [0 rgb <0, 0, 0.4>] [1 rgb <1, 0.9, 0.2>] } }
  translate <-0.5, -0.5, 0>
  scale <3.6, 2.6, 1>
}
