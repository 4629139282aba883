// planar: falls from 1 in the x-z plane to 0 at distance 1.
// lute scenes/feature/pattern/planar.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { planar frequency 3 color_map { [0 rgb 0] [1 rgb 1] } rotate 20*z scale 1.5 } }
