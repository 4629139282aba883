// waves: ten sources of different frequency, as a normal.
// lute scenes/feature/pattern/waves.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { rgb <0.1, 0.5, 0.5> } normal { waves 0.4 frequency 3 } finish { diffuse 0.7 phong 0.8 } }
