// image_map once: outside the picture the surface is clear, and light falls through.
// lute scenes/feature/pattern/image_map_once.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, 0.3, 0> right 4/3*x angle 45 }
light_source { <-2, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { y, 0 pigment { rgb 1 } }
box { <-1, 0, 0>, <1, 2, 0.1>
  pigment { image_map { png "test.png" once interpolate 2 } translate <-0.5, 0.5, 0> } }
