// hexagon: three colours in the x-z plane.
// lute scenes/feature/pattern/hexagon.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { hexagon rgb <0.8, 0.3, 0.2>, rgb <0.9, 0.8, 0.6>, rgb <0.2, 0.3, 0.4> rotate 90*x scale 0.4 } }
