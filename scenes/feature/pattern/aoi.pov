// aoi: by the angle under which the surface is seen.
// lute scenes/feature/pattern/aoi.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { aoi color_map { [0.5 rgb <1, 0.3, 0.1>] [1 rgb <0, 0, 0.3>] } } normal { wrinkles 0.7 } }
