// A dense scene for `lute-compare speed bench/scene`: a height field of 400 x 400 heights, smooth, that fills the picture.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.7, -1> right 4 / 3 * x look_at <0, -0.1, 0> angle 50 }
light_source { <-12, 6, -2> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.1 diffuse 0.7 } }
height_field {
  function 400, 400 { pattern { granite scale 2 } }
  smooth translate -0.5 scale <3, 0.3, 3>
}
