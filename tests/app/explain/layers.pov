// Two layers of texture, the upper one with crand: no picture of it can be compared, but what it needs can be told.
#version 3.7;
global_settings { assumed_gamma 1 noise_generator 3 }
camera { location -5*z look_at 0 right 4/3*x }
light_source { <3, 4, -5>, 1 }
sphere { 0, 1
  texture { pigment { bozo color_map { [0 rgb 1] [1 rgb <1, 0.5, 0>] } } }
  texture { pigment { rgbt <0, 0, 1, 0.5> } finish { crand 0.1 } }
}
