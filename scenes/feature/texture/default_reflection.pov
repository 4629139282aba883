// A reflecting #default finish: what a finish block of an object replaces and what it keeps.
// lute scenes/feature/texture/default_reflection.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

plane { z, 3 texture { pigment { checker rgb 1, rgb <0.2, 0.4, 0.8> scale 0.7 } finish { ambient 0.4 reflection 0 } } }
plane { -z, 12 texture { pigment { checker rgb <1, 0.8, 0.2>, rgb <0.6, 0.1, 0.1> scale 0.7 } finish { ambient 0.8 } } }
#default { finish { ambient 0.1 reflection { 0.2, 0.6 falloff 2 } phong 0.6 phong_size 20 } pigment { rgb 0.3 } }
sphere { <-3, 2, 0>, 0.8 }
sphere { <-1, 2, 0>, 0.8 finish { reflection 0.5 } }
sphere { <1, 2, 0>, 0.8 finish { phong 0 } }
sphere { <3, 2, 0>, 0.8 finish { reflection { 0.4 } } }
#default { finish { reflection { 0.5 metallic } metallic 0.5 } pigment { rgb <1, 0.6, 0.2> } }
sphere { <-3, 0, 0>, 0.8 }
sphere { <-1, 0, 0>, 0.8 finish { reflection { 0.6 } } }
sphere { <1, 0, 0>, 0.8 finish { metallic reflection 0.3 } }
sphere { <3, 0, 0>, 0.8 finish { specular 0.8 } }
#default { finish { diffuse albedo 0.5 brilliance 2 specular albedo 0.3 roughness 0.02 } }
sphere { <-3, -2, 0>, 0.8 }
sphere { <-1, -2, 0>, 0.8 finish { roughness 0.1 } }
sphere { <1, -2, 0>, 0.8 finish { brilliance 1 } }
sphere { <3, -2, 0>, 0.8 finish { diffuse 0.5 } }
