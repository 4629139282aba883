// Normals of every kind with odd parameters: amounts of 0 and below, large and small scales, accuracy, maps, averages, no_bump_scale.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <6,4,-10> look_at <6,4,0> right 12*x up 8*y }
light_source { <-20,30,-40> rgb 1 }
light_source { <30,-5,-20> rgb <0.3,0.2,0.4> }
background { rgb <0.1,0.2,0.3> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{bumps 0} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <0.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{bumps -0.7 scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <1.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{bumps 5 scale 0.1} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <2.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{bumps scale 0.1 bump_size 1.5} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <3.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{dents 1 scale 0.1} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <4.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{dents 1 scale <0.3,0.1,1>} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <5.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{wrinkles 0.8 scale <1,0.2,0.4> rotate 30} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <6.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{wrinkles 1 no_bump_scale scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <7.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{quilted 1 scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <8.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{quilted 1 control0 0.2 control1 -0.5 scale 0.3} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <9.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{ripples 0.6 scale 0.1} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <10.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{ripples 0.6 frequency 20 phase 0.3} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <11.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{ripples 1 frequency 0} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <0.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{waves 0.6 scale 0.1} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <1.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{waves 0.8 frequency 15 phase 2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <2.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{facets size 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <3.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{facets coords 0.4 size 0.1} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <4.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{facets size 0.3 metric 3} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <6.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{gradient x, 0.5 sine_wave scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <8.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{gradient x, 0.5 scallop_wave frequency 5} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <9.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{gradient y, 1 accuracy 0.1 scale 0.3} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <10.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{gradient y, 1 accuracy 1e-5 scale 0.3} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <11.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{granite 0.4 scale 0.3} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <0.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{agate 0.4 scale 0.3} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <1.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{crackle 0.6 scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <2.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{crackle 0.6 solid scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <3.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{bozo 2 scale 0.1} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <4.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{marble 0.7 turbulence 0.5 scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <5.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{wood 0.7 turbulence 0.1 scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <6.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{onion 0.5 scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <7.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{leopard 0.7 scale 0.03} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <8.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{radial 0.5 frequency 8} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <9.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{spiral1 4, 0.6 scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <10.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{spiral2 3, 0.6 scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <11.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{checker 0.5 scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <0.5,3.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{brick 0.6 scale 0.05} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <1.5,3.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{hexagon 0.5 scale 0.1} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <2.5,3.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{cells 1 scale 0.1} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <3.5,3.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{mandel 20, 1 scale 0.3} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <4.5,3.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{julia <0.3,0.3>,20, 0.6 scale 0.3} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <5.5,3.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{spherical 1} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <6.5,3.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{cylindrical 1 frequency 3} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <7.5,3.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{planar 1 sine_wave frequency 3} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <8.5,3.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{boxed 1} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <9.5,3.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{function{sin(x*20)*cos(y*20)} 0.4} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <10.5,3.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{pigment_pattern{bozo scale 0.1} 0.7} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <11.5,3.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{gradient x normal_map{[0 bumps 1 scale 0.1][1 dents 1 scale 0.2]} translate 0.5} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <9.5,4.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{gradient x normal_map{[0.5 bumps 1 scale 0.1][0.5 quilted 1 scale 0.1]} scale 0.3} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <10.5,4.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{checker normal{bumps 1 scale 0.1} normal{gradient x scale 0.1} scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <11.5,4.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{average normal_map{[1 bumps 1 scale 0.1][2 wrinkles 1 scale 0.1]}} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <1.5,5.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{average normal_map{[-1 bumps 1 scale 0.1][2 wrinkles 1 scale 0.1]} scale 2 rotate 20} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <2.5,5.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{gradient x, 1 slope_map{[0 <0,1>][0.3 <0.3,-1>][0.3 <0.5,0>][1 <1,2>]} scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <3.5,5.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{bumps 1 slope_map{[0 <0,1>][1 <1,2>]} scale 0.1} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <4.5,5.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{wood 1 slope_map{[0.5 <0.2,1>]} scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <5.5,5.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{onion 1 slope_map{[0 <0,0>][1 <1,0>]} frequency 5 triangle_wave} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <6.5,5.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{uv_mapping bumps 1 scale 0.1} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <7.5,5.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{uv_mapping gradient x, 1 scale 0.1} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <8.5,5.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{bumps 1 scale 0.1 warp{turbulence 0.3} warp{repeat 0.3*x flip x}} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <9.5,5.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{gradient x, 0.5 warp{spherical} scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <10.5,5.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{gradient x, 0.5 warp{black_hole 0,0.5 strength 2}} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <11.5,5.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{bumps 1 scale <1e-3,1,1>} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <0.5,6.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{bumps 1 scale 1e-4} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <1.5,6.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{bumps 1 scale 1e4} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <2.5,6.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{granite 1 matrix<1,0.5,0,0,1,0.3,0.2,0,1,1,2,3> scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <3.5,6.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{gradient x, 1 scale -0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <4.5,6.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{granite 0.5 no_bump_scale scale <0.1,0.4,0.2>} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <5.5,6.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{gradient x normal_map{[0 bumps 1 scale 0.1][1 granite 1 scale 0.2]} no_bump_scale scale 0.5} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <6.5,6.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{average normal_map{[1 bumps 1 scale 0.1][1 facets size 0.2]} no_bump_scale scale 2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <7.5,6.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{tiling 7, 0.5 scale 0.1} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <8.5,6.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{slope y, 0.5} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <10.5,6.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{aoi 0.5} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <11.5,6.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{square 0.5 scale 0.1} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <0.5,7.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{triangular 0.5 scale 0.1} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <1.5,7.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{cubic 0.5} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <2.5,7.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{object{sphere{0,0.3} } 0.5} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <3.5,7.5,0> }
sphere { 0, 0.47 pigment{rgb 0.9} normal{magnet 1 mandel 10, 0.5 scale 0.2} finish{diffuse 0.8 ambient 0.1 phong 0.3} translate <5.5,7.5,0> }
