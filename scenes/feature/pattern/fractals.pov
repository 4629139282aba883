// mandel, julia and magnet: many steps, where points that never escape fall into cycles; interior and exterior types.
// lute scenes/feature/pattern/fractals.pov -W240 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <2, 1, -10> look_at <2, 1, 0> right 4*x up 2*y }
#default { finish { ambient 0 emission 1 diffuse 0 } }

#macro Show(P, X, Y)
  box { 0, <0.98, 0.98, 1> pigment { P scale 0.25 translate <0.5, 0.5, 0> } translate <X, Y, 0> }
#end
#declare Grey = color_map { [0 rgb 0] [1 rgb 1] };
Show(pigment { mandel 2000 interior 1, 0.5 exterior 1, 1 color_map { Grey } }, 0, 1)
Show(pigment { mandel 500 exponent 4 interior 4, 1 color_map { Grey } }, 1, 1)
Show(pigment { julia <0.353, 0.288>, 300 interior 1, 1 exterior 6, 0.1 color_map { Grey } }, 2, 1)
Show(pigment { julia <-0.12, 0.74>, 1000 interior 5, 1 color_map { Grey } }, 3, 1)
Show(pigment { magnet 1 mandel 300 interior 1, 0.5 color_map { Grey } }, 0, 0)
Show(pigment { magnet 2 mandel 300 interior 6, 0.5 color_map { Grey } }, 1, 0)
Show(pigment { magnet 1 julia <0.2, 0.3>, 200 interior 2, 0.5 color_map { Grey } }, 2, 0)
Show(pigment { magnet 2 julia <0.1, 0.4>, 200 exterior 7, 5 color_map { Grey } }, 3, 0)
