// normal_map: two normals, blended.
// lute scenes/feature/pattern/normal_map.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

plane { z, 0 pigment { rgb <0.8, 0.8, 0.7> } normal { gradient x normal_map { [0.3 bumps 1 scale 0.05] [0.7 ripples 0.8 scale 0.05] } scale 4 translate -2*x } }
