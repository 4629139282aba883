// Normals over u and v bend the normal as the world has it: what turned the object or its texture does not count.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <2,1.5,-10> look_at <2,1.5,0> right 4*x up 3*y }
light_source { <-20,30,-40> rgb 1 }
light_source { <30,-5,-20> rgb <0.3,0.2,0.4> }
background { rgb <0.1,0.2,0.3> }
#declare Grey = pigment { rgb 0.8 };
box { -0.3, 0.3 pigment { Grey } normal { uv_mapping ripples 0.6 scale 0.1 } rotate <20,40,0> translate <0.5,0.5,0> }
torus { 0.25, 0.13 pigment { Grey } normal { uv_mapping bumps 0.9 scale 0.1 } rotate -60*x translate <1.5,0.5,0> }
sphere { 0, 0.4 pigment { Grey } normal { uv_mapping granite 0.4 scale 0.2 rotate 30*z } rotate <30,0,20> translate <2.5,0.5,0> }
cylinder { -0.35*y, 0.35*y, 0.3 texture { pigment { Grey } normal { uv_mapping wrinkles 1 scale 0.1 } rotate 50 } rotate 30*z translate <3.5,0.5,0> }
sphere { 0, 0.4 texture { gradient y texture_map { [0.3 pigment { Grey } normal { uv_mapping bumps 1 scale 0.1 }] [0.6 pigment { rgb x }] } scale 0.5 rotate 40*z } rotate 30 translate <0.5,1.5,0> }
box { -0.3, 0.3 pigment { Grey } normal { uv_mapping bumps 1 scale 0.1 no_bump_scale } scale <1,0.5,1.2> rotate <20,40,0> translate <1.5,1.5,0> }
sphere { 0, 0.4 pigment { Grey } normal { average normal_map { [1 uv_mapping bumps 1 scale 0.1] [1 granite 0.3] } } rotate 60*x translate <2.5,1.5,0> }
sphere { 0, 0.4 uv_mapping pigment { Grey } normal { ripples 0.6 scale 0.1 } rotate <60,0,30> translate <3.5,1.5,0> }
box { -0.3, 0.3 uv_mapping texture { pigment { Grey } normal { bumps 1 scale 0.1 } } rotate <20,40,0> translate <0.5,2.5,0> }
box { -0.3, 0.3 texture { uv_mapping pigment { Grey } normal { bumps 1 scale 0.1 } } rotate <20,40,0> translate <1.5,2.5,0> }
union { sphere { 0, 0.4 } box { -0.3, 0.3 } pigment { Grey } normal { uv_mapping quilted 1 scale 0.2 } rotate <20,40,0> translate <2.5,2.5,0> }
sphere { 0, 0.4 pigment { slope y } normal { uv_mapping bumps 1 scale 0.1 } finish { ambient 1 } rotate 60*x translate <3.5,2.5,0> }
