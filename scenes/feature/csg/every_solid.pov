// each solid cut by a box and by a sphere: all hits and the inside test of each are used.
// lute scenes/feature/csg/every_solid.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

#macro Cell(I, Solid)
  difference {
    object { Solid }
    box { <-2, -2, -2>, <2, 2, 0> rotate <-25, 35, 0> pigment { rgb <1, 0.3, 0.2> } }
    sphere { 0, 0.25 pigment { rgb <0.3, 0.4, 1> } }
    scale 0.48 translate <mod(I, 5) - 2, 1 - div(I, 5), 0>
  }
#end
Cell(0, cone { <0, -0.8, 0>, 0.8, <0, 0.8, 0>, 0.3 })
Cell(1, torus { 0.6, 0.3 rotate 60 * x })
Cell(2, superellipsoid { <0.4, 0.6> scale 0.8 })
Cell(3, blob { threshold 0.5 sphere { -0.3, 1, 1 } sphere { 0.3, 1, 1 } })
Cell(4, sor { 5, <0.1, -1.2>, <0.6, -0.8>, <0.4, 0>, <0.7, 0.8>, <0.3, 1.2> })
Cell(5, lathe { cubic_spline 6, <0, -1>, <0, -0.8>, <0.8, -0.2>, <0.4, 0.4>, <0, 0.8>, <0, 1> })
Cell(6, prism { linear_spline -0.6, 0.6, 5, <-0.7, -0.7>, <0.7, -0.6>, <0.6, 0.7>, <-0.5, 0.7>, <-0.7, -0.7> })
Cell(7, sphere_sweep { linear_spline 3, <-0.6, -0.4, 0>, 0.4, <0.4, 0.4, 0>, 0.5, <0.5, -0.6, 0>, 0.3 })
Cell(8, ovus { 0.6, 0.3 })
Cell(9, quadric { <1.5, 2, 3>, <0.3, 0, 0>, <0, 0, 0>, -1 })
Cell(10, polynomial { 4, xyz(4, 0, 0): 1, xyz(0, 4, 0): 1, xyz(0, 0, 4): 1, xyz(0, 0, 0): -0.4 })
Cell(11, isosurface { function { x * x + y * y + z * z - 0.6 + 0.2 * sin(9 * x) } max_gradient 4 max_trace 4 contained_by { box { -1, 1 } } })
Cell(12, text { ttf "timrom.ttf" "B" 0.8, 0 translate <-0.35, -0.35, -0.4> scale 2 })
Cell(13, cylinder { -0.8 * x, 0.8 * x, 0.6 })
Cell(14, box { -0.6, 0.6 rotate 30 * z })
