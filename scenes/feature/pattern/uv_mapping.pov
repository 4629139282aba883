// uv_mapping: a checker on the coordinates of a sphere.
// lute scenes/feature/pattern/uv_mapping.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

sphere { <-1, 0, 0>, 0.9 pigment { uv_mapping checker scale 0.1 } }
torus { 0.6, 0.3 pigment { uv_mapping checker rgb 1, rgb <0.8, 0.2, 0.1> scale 0.1 } rotate -50*x translate x }
