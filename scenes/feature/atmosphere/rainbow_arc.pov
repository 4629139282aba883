// rainbow with arc_angle and falloff_angle: a part of a bow, faded at its ends.
// lute scenes/feature/atmosphere/rainbow_arc.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> right 4 / 3 * x look_at <0, 1, 0> angle 50 }
light_source { <-4, 6, -8> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.7> } hollow }
#for (I, 0, 4)
  sphere { <2 * I - 4, 0, 4 * I>, 1 pigment { rgb <1, 0.6, 0.3> } }
#end

background { rgb <0.3, 0.4, 0.5> }
rainbow { angle 25 width 12 distance 1000 direction <0, 0, 1> up y arc_angle 120 falloff_angle 60 jitter 0
  color_map { [0 rgbt <0.5, 0, 1, 1>] [0.5 rgbt <0.2, 1, 0.2, 0.2>] [1 rgbt <1, 0, 0, 1>] } }
