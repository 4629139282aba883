// tiling: all 27 of them, from the upper left corner on.
// lute scenes/feature/pattern/tilings.pov -W360 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4.5, 1.5, -10> look_at <4.5, 1.5, 0> right 9*x up 3*y }
#default { finish { ambient 0 emission 1 diffuse 0 } }

#for (I, 0, 26)
  box {
    0, <0.98, 0.98, 1>
    pigment { tiling I+1 color_map { [0 rgb 0] [1 rgb <1, 0.9, 0.7>] } scale 0.12 rotate -90*x translate <0.5, 0.5, 0> }
    translate <mod(I, 9), 2 - int(I/9), 0>
  }
#end
