#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 7 }
camera { location <0, 2, -5> look_at 0 angle 50 }
light_source { <10, 20, -30>, rgb <1, 0.9, 0.8> spotlight radius 10 falloff 20 point_at 0 area_light x, y, 3, 3 jitter }
#declare Ball = sphere { 0, 1.2 }
difference {
  box { -1, 1 }
  object { Ball scale 1.1 }
  pigment { rgb x }
  rotate 30*y
  clipped_by { plane { y, 0.5 } }
  inverse
}
union { torus { 1, 0.25 sturm } cone { 0, 1, y, 0 open } no_shadow hollow photons { target 2 reflection on } }
