// text: a font file of the package, the built-in fonts, thickness and offset.
// lute scenes/feature/shape/text.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

text { ttf "timrom.ttf" "Lute" 0.3, 0 translate <-1.9, 0.3, 0> }
text { internal 1 "Ab3" 0.5, <0.1, 0.1, 0> rotate 20 * y translate <0.2, 0.3, 0> }
text { ttf "cyrvetic.ttf" "gaj" 0.2, 0.1 * x rotate -20 * y translate <-1.9, -0.9, 0> }
text { internal 3 "R8&" 0.3, 0 rotate <20, 20, 0> translate <0.2, -0.9, 0> }
