// text in CSG: engraved and cut.
// lute scenes/feature/shape/text_csg.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

difference { box { <-1.8, -0.5, 0>, <1.6, 1, 1> } text { ttf "timrom.ttf" "Engrave" 0.4, 0 scale <1, 1, 1> translate <-1.6, 0.05, -0.1> pigment { rgb <0.9, 0.3, 0.2> } }
  rotate 15 * y }
intersection { text { ttf "crystal.ttf" "CUT" 0.5, 0 scale 1.2 } cylinder { <1, 0.4, -1>, <1, 0.4, 2>, 0.75 } translate <-1, -1.5, 0> }
