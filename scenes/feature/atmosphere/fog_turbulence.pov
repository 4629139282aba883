// fog with turbulence: its thickness varies.
// lute scenes/feature/atmosphere/fog_turbulence.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> right 4 / 3 * x look_at <0, 1, 0> angle 50 }
light_source { <-4, 6, -8> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.7> } hollow }
#for (I, 0, 4)
  sphere { <2 * I - 4, 0, 4 * I>, 1 pigment { rgb <1, 0.6, 0.3> } }
#end

background { rgb <0.4, 0.6, 0.9> }
fog { distance 10 rgb <0.7, 0.7, 0.8> turbulence <1, 0.5, 1> turb_depth 0.3 octaves 4 omega 0.6 lambda 2 }
