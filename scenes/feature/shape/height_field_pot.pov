// height_field of a POT image: two bytes a height.
// lute scenes/feature/shape/height_field_pot.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

height_field { pot "mtmand.pot" smooth
  translate <-0.5, 0, -0.5> scale <2.6, 0.6, 2.6> rotate <-25, 20, 0> }
