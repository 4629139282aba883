// crackle: metrics whose powers are multiplied, and others; forms with one, two and three distances; an offset.
// lute scenes/feature/pattern/crackle_metrics.pov -W240 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <2, 1, -10> look_at <2, 1, 0> right 4*x up 2*y }
#default { finish { ambient 0 emission 1 diffuse 0 } }

#declare Metrics = array[8] { 0.5, 0.7, 1, 1.5, 2, 2.5, 3, 6 };
#declare Forms = array[4] { <-1, 1, 0>, <1, 0, 0>, <0.4, 0.4, -0.4>, <-0.2, 0, 0.9> };
#for (I, 0, 7)
  box {
    0, <0.98, 0.98, 1>
    pigment { crackle metric Metrics[I] form Forms[mod(I, 4)] offset (I > 5 ? 0.2 : 0) color_map { [0 rgb 0] [1 rgb 1] } scale 0.15 }
    translate <mod(I, 4), int(I/4), 0>
  }
#end
