// bicubic_patch, type 1: divided once; without flatness it has 4^steps cells.
// lute scenes/feature/shape/bicubic_patch_type_1.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

bicubic_patch { type 1 flatness 0 u_steps 2 v_steps 3
  <-1.5, 0, -1.5>, <-0.5, 0.8, -1.5>, <0.5, 0.8, -1.5>, <1.5, 0, -1.5>,
  <-1.5, 0.8, -0.5>, <-0.5, -1, -0.5>, <0.5, -1, -0.5>, <1.5, 0.8, -0.5>,
  <-1.5, 0.8, 0.5>, <-0.5, 1, 0.5>, <0.5, -1, 0.5>, <1.5, 0.8, 0.5>,
  <-1.5, 0, 1.5>, <-0.5, 0.8, 1.5>, <0.5, 0.8, 1.5>, <1.5, 0.4, 1.5> scale 0.8 rotate 20 * y }
