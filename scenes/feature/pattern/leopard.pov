// leopard: spots from three sines.
// lute scenes/feature/pattern/leopard.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { leopard color_map { [0 rgb <0.9, 0.7, 0.4>] [0.3 rgb <0.5, 0.3, 0.1>] [0.6 rgb 0] } scale 0.12 } }
