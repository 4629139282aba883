// dents: the third power of noise, as a normal.
// lute scenes/feature/pattern/dents.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { rgb <0.6, 0.6, 0.7> } normal { dents 1.5 scale 0.3 } finish { diffuse 0.7 phong 0.5 } }
