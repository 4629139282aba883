// uv_mapping of a union, bounded_by and clipped_by of copies: what of a texture they change.
// lute scenes/feature/texture/uv_and_bounds.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y look_at 0 }
light_source { <-4, 6, -8> rgb 1 }

#default { pigment { gradient x color_map { [0 rgb x] [0.5 rgb 1] [1 rgb z] } scale 0.25 } finish { ambient 0.4 } }
sphere { <-3, 2, 0>, 0.8 uv_mapping pigment { checker scale 0.1 } }
sphere { <-1, 2, 0>, 0.8 pigment { uv_mapping checker scale 0.1 } }
union { sphere { -0.4 * x, 0.5 } sphere { 0.4 * x, 0.5 } uv_mapping pigment { gradient y scale 0.2 } translate <1, 2, 0> }
union { sphere { -0.4 * x, 0.5 pigment { gradient y scale 0.2 } } sphere { 0.4 * x, 0.5 } uv_mapping pigment { rgb 1 } translate <3, 2, 0> }
box { -0.7, 0.7 uv_mapping texture { pigment { hexagon } scale 0.1 } rotate 30 translate <-3, 0, 0> }
object { sphere { 0, 0.8 texture { } } clipped_by { plane { y, 0.2 } } translate <-1, 0, 0> }
object { sphere { 0, 0.8 texture { } } clipped_by { plane { y, 0.2 } } bounded_by { clipped_by } translate <1, 0, 0> }
union { sphere { -0.4 * x, 0.5 } sphere { 0.4 * x, 0.5 texture { } } clipped_by { plane { x, 0.5 } } translate <3, 0, 0> }
sphere { 0, 0.8 texture { uv_mapping checker texture { pigment { rgb 1 } }, texture { pigment { rgb x } } scale 0.1 } translate <-3, -2, 0> }
torus { 0.5, 0.3 uv_mapping pigment { checker scale 0.1 } rotate -60 * x translate <-1, -2, 0> }
union { torus { 0.5, 0.3 } sphere { 0, 0.2 pigment { rgb y } } uv_mapping pigment { checker scale 0.1 } rotate -60 * x translate <1, -2, 0> }
object { sphere { 0, 0.8 uv_mapping pigment { checker scale 0.1 } } pigment { hexagon } translate <3, -2, 0> }
