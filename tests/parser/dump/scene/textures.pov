#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.2 } }
plane { y, 0
  texture {
    checker
    texture { pigment { marble turbulence 0.5 color_map { [0 rgb 0] [1 rgb <1, 0.5, 0.25>] } warp { repeat 2*x flip x } scale 3 } }
    texture { pigment { rgbft <1, 1, 1, 0.25, 0.5> } finish { reflection { 0.1, 0.9 fresnel } phong albedo 0.5 } }
  }
}
sphere { 0, 1
  uv_mapping
  pigment { average pigment_map { [2 bozo] [wood] } }
  normal { gradient x, 0.4 slope_map { [0 <0, 1>] [1 <1, 0>] } }
}
