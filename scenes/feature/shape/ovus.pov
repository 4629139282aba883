// ovus: an egg of a bottom and a top radius.
// lute scenes/feature/shape/ovus.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

ovus { 0.7, 0.35 translate <-1.2, -0.3, 0> }
ovus { 0.4, 0.5 rotate 30 * z translate <0.4, -0.3, 0> }
ovus { 0.5, 0.2 sturm scale <1, 1.3, 0.5> rotate <20, 30, -40> translate <1.4, -0.2, 0> }
