// Blend maps, lists, default colours, averages and images (chapter 50 §10-11): colours at ten points.
#version 3.7;
global_settings { assumed_gamma 1 }
#fopen W "out.txt" write
#declare Ball = sphere { 0, 1.5 }
#declare Ramp = pigment { gradient x }
#declare Place = array[10] { <0.25,0.5,0.75>, <-1.3,2.7,0.4>, <17.1,-5.6,33.3>, <0.5,0.2,-0.7>, <0.1,0.12,0>, <-1,-1,-1>, <0.9,0.95,0.85>, <-2.31,0.77,1.93>, <2.6,-1.9,-0.3>, <0.31,-0.62,2.2> }
#macro Values(Name)
  #write(W, Name, ":")
  #local I = 0;
  #while (I < 10)
    #local C = F(Place[I].x, Place[I].y, Place[I].z);
    #write(W, " ", str(C.red,0,9), " ", str(C.green,0,9), " ", str(C.blue,0,9), " ", str(C.filter,0,9), " ", str(C.transmit,0,9))
    #local I = I + 1;
  #end
  #write(W, "\n")
#end
#declare F = function { pigment { average pigment_map{[1 rgb x][2 gradient x]} } } Values("average pigment_map{[1 rgb x][2 gradient x]}") #undef F
#declare F = function { pigment { average pigment_map{[-1 rgb x][3 rgb y]} } } Values("average pigment_map{[-1 rgb x][3 rgb y]}") #undef F
#declare F = function { pigment { gradient x color_map{[0 rgb x][0.5 rgb y][0.5 rgb z][1 rgbft <1,1,1,0.5,0.3>]} } } Values("gradient x color_map{[0 rgb x][0.5 rgb y][0.5 rgb z][1 rgbft <1,1,1,0.5,0.3>]}") #undef F
#declare F = function { pigment { gradient x color_map{[0.3 rgb x][0.2 rgb y][0.9 rgb z]} } } Values("gradient x color_map{[0.3 rgb x][0.2 rgb y][0.9 rgb z]}") #undef F
#declare F = function { pigment { gradient x color_map{[0.5 rgb x]} } } Values("gradient x color_map{[0.5 rgb x]}") #undef F
#declare F = function { pigment { gradient x color_map{[-1 rgb x][2 rgb z]} } } Values("gradient x color_map{[-1 rgb x][2 rgb z]}") #undef F
#declare F = function { pigment { gradient x color_map{[0 rgb x][0 rgb y][1 rgb z][1 rgb 1]} } } Values("gradient x color_map{[0 rgb x][0 rgb y][1 rgb z][1 rgb 1]}") #undef F
#declare F = function { pigment { gradient x color_map{[0.25 rgb x][0.25 rgb y][0.25 rgb z]} } } Values("gradient x color_map{[0.25 rgb x][0.25 rgb y][0.25 rgb z]}") #undef F
#declare F = function { pigment { gradient x pigment_map{[0 Ramp][0.5 rgb y][1 bozo scale 0.1]} } } Values("gradient x pigment_map{[0 Ramp][0.5 rgb y][1 bozo scale 0.1]}") #undef F
#declare F = function { pigment { gradient x pigment_map{[0.5 Ramp]} } } Values("gradient x pigment_map{[0.5 Ramp]}") #undef F
#declare F = function { pigment { checker pigment{Ramp} pigment{rgb x} } } Values("checker pigment{Ramp} pigment{rgb x}") #undef F
#declare F = function { pigment { checker pigment{Ramp} } } Values("checker pigment{Ramp}") #undef F
#declare F = function { pigment { checker rgb x } } Values("checker rgb x") #undef F
#declare F = function { pigment { checker } } Values("checker") #undef F
#declare F = function { pigment { brick rgb x rgb y brick_size 0.5 mortar 0.1 } } Values("brick rgb x rgb y brick_size 0.5 mortar 0.1") #undef F
#declare F = function { pigment { hexagon rgb x rgb y rgb z } } Values("hexagon rgb x rgb y rgb z") #undef F
#declare F = function { pigment { hexagon rgb x } } Values("hexagon rgb x") #undef F
#declare F = function { pigment { square rgb x rgb y } } Values("square rgb x rgb y") #undef F
#declare F = function { pigment { square } } Values("square") #undef F
#declare F = function { pigment { triangular } } Values("triangular") #undef F
#declare F = function { pigment { triangular pigment{Ramp} pigment{rgb x} } } Values("triangular pigment{Ramp} pigment{rgb x}") #undef F
#declare F = function { pigment { cubic } } Values("cubic") #undef F
#declare F = function { pigment { cubic rgb x, rgb y, rgb z } } Values("cubic rgb x, rgb y, rgb z") #undef F
#declare F = function { pigment { object{Ball rgb x rgb y} } } Values("object{Ball rgb x rgb y}") #undef F
#declare F = function { pigment { object{Ball} } } Values("object{Ball}") #undef F
#declare F = function { pigment { object{Ball pigment{Ramp} pigment{bozo}} scale 0.3 } } Values("object{Ball pigment{Ramp} pigment{bozo}} scale 0.3") #undef F
#declare F = function { pigment { agate } } Values("agate") #undef F
#declare F = function { pigment { radial } } Values("radial") #undef F
#declare F = function { pigment { wood } } Values("wood") #undef F
#declare F = function { pigment { marble } } Values("marble") #undef F
#declare F = function { pigment { bozo } } Values("bozo") #undef F
#declare F = function { pigment { mandel 20 } } Values("mandel 20") #undef F
#declare F = function { pigment { mandel 20 exponent 3 } } Values("mandel 20 exponent 3") #undef F
#declare F = function { pigment { julia <0.3,0.2>,10 } } Values("julia <0.3,0.2>,10") #undef F
#declare F = function { pigment { leopard } } Values("leopard") #undef F
#declare F = function { pigment { crackle } } Values("crackle") #undef F
#declare F = function { pigment { granite } } Values("granite") #undef F
#declare F = function { pigment { Ramp color_map{[0 rgb x][1 rgb y]} } } Values("Ramp color_map{[0 rgb x][1 rgb y]}") #undef F
#declare F = function { pigment { Ramp translate 0.3 frequency 2 } } Values("Ramp translate 0.3 frequency 2") #undef F
#declare F = function { pigment { pigment_pattern{Ramp} } } Values("pigment_pattern{Ramp}") #undef F
#declare F = function { pigment { pigment_pattern{Ramp} color_map{[0 rgb x][1 rgb z]} } } Values("pigment_pattern{Ramp} color_map{[0 rgb x][1 rgb z]}") #undef F
#declare F = function { pigment { aoi } } Values("aoi") #undef F
#declare F = function { pigment { pavement form 5 interior 4 exterior 4 } } Values("pavement form 5 interior 4 exterior 4") #undef F
#declare F = function { pigment { pavement number_of_sides 4 number_of_tiles 4 pattern 3 form 5 } } Values("pavement number_of_sides 4 number_of_tiles 4 pattern 3 form 5") #undef F
#declare F = function { pigment { pavement form -1 } } Values("pavement form -1") #undef F
#declare F = function { pigment { rgbt <1,2,3,4> } } Values("rgbt <1,2,3,4>") #undef F
#declare F = function { pigment { color rgb 0.5 } } Values("color rgb 0.5") #undef F
#declare F = function { pigment { rgb x quick_color rgb y } } Values("rgb x quick_color rgb y") #undef F
#declare F = function { pigment { image_map{function 4,4{pigment{Ramp}}} } } Values("image_map{function 4,4{pigment{Ramp}}}") #undef F
#declare F = function { pigment { image_map{function 4,4{x} interpolate 2} } } Values("image_map{function 4,4{x} interpolate 2}") #undef F
#declare F = function { pigment { image_map{function 4,4{pattern{bozo}}} } } Values("image_map{function 4,4{pattern{bozo}}}") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } }  } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } }  }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } interpolate 2 } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } interpolate 2 }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } interpolate 3 } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } interpolate 3 }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } interpolate 4 } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } interpolate 4 }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } once } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } once }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } once interpolate 2 } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } once interpolate 2 }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } once interpolate 3 } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } once interpolate 3 }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } filter all 0.3 } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } filter all 0.3 }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } transmit all 0.2 } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } transmit all 0.2 }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } map_type 1 } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } map_type 1 }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } map_type 2 interpolate 2 } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } map_type 2 interpolate 2 }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } map_type 5 interpolate 2 } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } map_type 5 interpolate 2 }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } map_type 2 once } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } map_type 2 once }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } map_type 1 once } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } map_type 1 once }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } repeat <2,1> } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } repeat <2,1> }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } offset <0.3,-2> } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } offset <0.3,-2> }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } once repeat 2 } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } once repeat 2 }") #undef F
#declare F = function { pigment { image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } once offset 0.3 } } } Values("image_map { function 7, 5 { pigment { bozo scale 0.2 color_map { [0.3 rgbt <1,0,0,0.2>] [0.7 rgbt <0,0.4,1,0.7>] } } } once offset 0.3 }") #undef F
#declare F = function { pigment { image_pattern { function 7, 5 { pattern { bozo scale 0.2 } }  } } } Values("image_pattern { function 7, 5 { pattern { bozo scale 0.2 } }  }") #undef F
#declare F = function { pigment { image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } interpolate 2 } } } Values("image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } interpolate 2 }") #undef F
#declare F = function { pigment { image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } interpolate 3 } } } Values("image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } interpolate 3 }") #undef F
#declare F = function { pigment { image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } interpolate 4 } } } Values("image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } interpolate 4 }") #undef F
#declare F = function { pigment { image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } once } } } Values("image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } once }") #undef F
#declare F = function { pigment { image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } use_alpha } } } Values("image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } use_alpha }") #undef F
#declare F = function { pigment { image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } use_color } } } Values("image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } use_color }") #undef F
#declare F = function { pigment { image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } map_type 1 } } } Values("image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } map_type 1 }") #undef F
#declare F = function { pigment { image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } map_type 2 } } } Values("image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } map_type 2 }") #undef F
#declare F = function { pigment { image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } map_type 5 } } } Values("image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } map_type 5 }") #undef F
#declare F = function { pigment { image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } repeat <2,3> } } } Values("image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } repeat <2,3> }") #undef F
#declare F = function { pigment { image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } offset <0.3,0.4> } } } Values("image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } offset <0.3,0.4> }") #undef F
#declare F = function { pigment { image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } } frequency 2 phase 0.3 } } Values("image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } } frequency 2 phase 0.3") #undef F
#declare F = function { pigment { image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } } sine_wave } } Values("image_pattern { function 7, 5 { pattern { bozo scale 0.2 } } } sine_wave") #undef F
#declare F = function { pigment { image_map { function 1, 1 { 0.4 } interpolate 2 } } } Values("image_map { function 1, 1 { 0.4 } interpolate 2 }") #undef F
#declare F = function { pigment { image_pattern { function 3, 2 { x*1e10 } } } } Values("image_pattern { function 3, 2 { x*1e10 } }") #undef F
#declare F = function { pigment { image_pattern { function 3, 2 { x*3-5 } } } } Values("image_pattern { function 3, 2 { x*3-5 } }") #undef F
#declare F = function { pigment { object { Ball } } } Values("object { Ball }") #undef F
#declare F = function { pigment { object { Ball rgb x } } } Values("object { Ball rgb x }") #undef F
#declare F = function { pigment { average pigment_map{[1 image_map{function 3,3{x} once}][1 rgb x]} } } Values("average pigment_map{[1 image_map{function 3,3{x} once}][1 rgb x]}") #undef F
#declare F = function { pigment { brick brick_size 0 } } Values("brick brick_size 0") #undef F
#declare F = function { pigment { brick brick_size <1,0,1> } } Values("brick brick_size <1,0,1>") #undef F
