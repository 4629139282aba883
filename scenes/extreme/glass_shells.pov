// Two hundred shells of glass, one in the other, each a little denser than the one around it, before a striped wall: light bends at
// every surface, and a ray that would cross more than 256 of them ends in the black of max_trace_level.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 256 adc_bailout 0 }
camera { orthographic location -5*z direction z right 4*x up 3*y }
#for (I, 1, 200)
  sphere { 0, 1 + I/200 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1 + (201 - I)/2000 } }
#end
plane { -z, -3
  pigment { function { mod(floor(4*x) + 100, 2) } color_map { [0.5 rgb <0, 0.5, 0>] [0.5 rgb <1, 1, 0>] } }
  finish { ambient 1 diffuse 0 }
}
