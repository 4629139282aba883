#version 3.7;
global_settings { assumed_gamma 1 number_of_waves 3 noise_generator 2 }
// Every pattern once, with what it can be told.
#macro Show(Pigment) sphere { 0, 1 pigment { Pigment } } #end
#macro Bump(Pattern) sphere { 0, 1 normal { Pattern } } #end
Show(pigment { agate agate_turb 0.5 })
Show(pigment { aoi })
Show(pigment { boxed })
Show(pigment { bozo turbulence <0.1, 0.2, 0.3> octaves 4 omega 0.6 lambda 1.5 frequency 2 phase 0.25 sine_wave })
Show(pigment { brick rgb 1, rgb 0 brick_size <4, 2, 3> mortar 0.25 })
Show(pigment { cells })
Show(pigment { checker rgb 1, rgb 0 })
Show(pigment { crackle form <1, 0, 0> metric 1 offset 0.5 solid })
Show(pigment { cubic rgb 0 rgb 1 rgb x rgb y rgb z rgb <1, 1, 0> })
Show(pigment { cylindrical triangle_wave })
Show(pigment { function { x + y * z } })
Show(pigment { gradient <1, 1, 0> scallop_wave })
Show(pigment { granite })
Show(pigment { hexagon rgb 1, rgb 0, rgb x })
Show(pigment { image_map { function 2, 2 { x } once interpolate 2 filter all 0.5 transmit all 0.25 } })
Show(pigment { image_pattern { function 2, 2 { y } map_type 1 } })
Show(pigment { julia <0.353, 0.288>, 30 exponent 3 interior 1, 2 exterior 2, 3 })
Show(pigment { leopard poly_wave 2 })
Show(pigment { magnet 2 mandel 20 })
Show(pigment { magnet 1 julia <0.5, 0.25>, 20 })
Show(pigment { mandel 25 exponent 4 })
Show(pigment { marble ramp_wave })
Show(pigment { object { sphere { 0, 0.5 } rgb 0, rgb 1 } })
Show(pigment { onion cubic_wave })
Show(pigment { pavement number_of_sides 4 number_of_tiles 3 pattern 2 form 1 interior 2 exterior 1 })
Show(pigment { pigment_pattern { wood } })
Show(pigment { planar })
Show(pigment { quilted control0 0.5 control1 0.25 })
Show(pigment { radial })
Show(pigment { slope { point_at y, 0.25, 0.75 } })
Show(pigment { slope { y, 0, 0.5 altitude x, 0.25, 1 } })
Show(pigment { spherical })
Show(pigment { spiral1 3 })
Show(pigment { spiral2 -2 })
Show(pigment { spotted })
Show(pigment { square rgb 0 rgb 1 rgb x rgb y })
Show(pigment { tiling 7 })
Show(pigment { triangular rgb 0 rgb 1 rgb x rgb y rgb z rgb <1, 1, 0> })
Show(pigment { wood turbulence 0.1 })
Bump(normal { bumps 0.25 })
Bump(normal { dents 0.5 no_bump_scale })
Bump(normal { facets size 0.5 coords 0.25 metric 1 })
Bump(normal { bump_map { function 2, 2 { x } bump_size 2 use_index } })
Bump(normal { ripples accuracy 0.01 })
Bump(normal { waves 0.5 })
Bump(normal { wrinkles 0.5 slope_map { [0 <0, 1>] [1 <1, 1>] } })
sphere { 0, 1 texture { material_map { function 2, 2 { x } texture { pigment { rgb x } } texture { pigment { rgb y } } } } }
// Every warp and transformation.
sphere { 0, 1 pigment { bozo
  warp { repeat x offset y flip <1, 0, 1> }
  warp { black_hole <1, 2, 3>, 0.5 strength 2 falloff 3 inverse repeat <4, 5, 6> turbulence 0.1 }
  warp { turbulence 0.5 octaves 3 lambda 2.5 omega 0.25 }
  warp { planar y, 0.5 } warp { cylindrical orientation y dist_exp 2 } warp { spherical orientation x }
  warp { toroidal orientation z dist_exp 1 major_radius 2 } warp { cubic }
  translate x rotate 90*z scale <1, 2, 3> matrix <1, 0, 0, 0.5, 1, 0, 0, 0, 1, 4, 5, 6> } }
