// brick: mortar, brick.
// lute scenes/feature/pattern/brick.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { brick rgb 0.8, rgb <0.6, 0.2, 0.1> brick_size <1, 0.4, 0.5> mortar 0.06 translate 0.2*z } }
