// Orthographic camera: all rays have the camera's direction, their origins fill the rectangle right × up; parallel edges stay parallel.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.8, 0.83, 0.88> }
camera { orthographic location <6, 5, -6> right x * 8 up y * 6 look_at <0, 0.9, 0> }
light_source { <2, 9, -9> rgb 1 }
#for (I, -2, 2)
  #for (J, -2, 2)
    box { <I - 0.35, 0, J - 0.35>, <I + 0.35, 0.5 + 0.3 * mod(abs(I * 2 + J * 3), 4), J + 0.35> pigment { rgb <0.6 + 0.15 * I, 0.55, 0.6 - 0.15 * J> } }
  #end
#end
plane { y, 0 pigment { checker rgb 0.9, rgb 0.8 } }
