// cylinder 2: horizontal, fixed viewpoint.
// lute scenes/feature/camera/cylinder_2.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.7 } }

camera { cylinder 2 location <0, 0.5, 0> right 4 / 3 * x angle 140 look_at <0, 0.2, 1> }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.7> } }
#for (I, 0, 11)
  sphere { 3 * x, 0.6 rotate 12 * mod(I, 3) * z rotate 30 * I * y pigment { rgb <0.5 + 0.04 * I, 1 - 0.07 * I, mod(I, 2)> } }
#end
cylinder { <-4, 2, -4>, <4, 2, 4>, 0.3 pigment { rgb <1, 0.9, 0.3> } }
