// two fogs.
// lute scenes/feature/atmosphere/fogs.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> right 4 / 3 * x look_at <0, 1, 0> angle 50 }
light_source { <-4, 6, -8> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.7> } hollow }
#for (I, 0, 4)
  sphere { <2 * I - 4, 0, 4 * I>, 1 pigment { rgb <1, 0.6, 0.3> } }
#end

background { rgb <0.4, 0.6, 0.9> }
fog { distance 30 rgb <0.9, 0.7, 0.6> }
fog { fog_type 2 distance 5 rgb <0.6, 0.7, 0.9> fog_offset -1 fog_alt 0.3 }
