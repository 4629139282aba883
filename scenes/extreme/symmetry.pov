// One shape on a floor, lit by a lamp, wherever place.inc puts it. Declare=Shape=N chooses the shape.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "place.inc"
#ifndef (Shape) #declare Shape = 0; #end
camera {
  location <0.5, 2.2, -5>
  right 4/3*x
  look_at <0, 0.1, 0>
  angle 42
  transform Place
}
light_source { <4, 7, -6>, rgb 0.9 transform Place }
background { rgb <0.3, 0.45, 0.7> }
#macro Net(I)
  <mod(I, 5) - 2, 0.5 + 0.45*sin(I*1.7), div(I, 5) - 2>
#end
#declare Thing =
  #switch (Shape)
  #case (0) sphere { 0, 1 } #break
  #case (1) box { <-0.8, -0.9, -0.7>, <0.8, 0.7, 0.8> rotate <10, 25, 5> } #break
  #case (2) cylinder { <-0.7, -0.6, 0>, <0.8, 0.6, 0.3>, 0.5 } #break
  #case (3) cone { <0, -0.9, 0>, 0.9, <0.2, 0.9, 0.1>, 0.2 } #break
  #case (4) torus { 0.9, 0.35 rotate <35, 0, 20> } #break
  #case (5) disc { <0, 0.3, 0>, <0.3, 1, -0.8>, 1.1, 0.4 } #break
  #case (6) quadric { <1, -0.8, 1>, <0.2, 0.1, 0>, <0, 0, 0>, -0.3 clipped_by { box { -1, 1 } } } #break
  #case (7) quartic { <1, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
                       1, 0, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, -1, 0, 0.12> clipped_by { box { -1.2, 1.2 } } } #break
  #case (8) superellipsoid { <0.35, 0.5> rotate <20, 30, 0> } #break
  #case (9) blob { threshold 0.5 sphere { <-0.4, 0, 0>, 0.9, 1 } sphere { <0.5, 0.2, -0.1>, 0.8, 1 }
                   cylinder { <0, -0.6, 0>, <0, 0.7, 0.4>, 0.5, 0.8 } } #break
  #case (10) sor { 6, <0.5, -1>, <0.8, -0.6>, <0.4, 0>, <0.6, 0.5>, <0.3, 0.9>, <0.2, 1> } #break
  #case (11) lathe { cubic_spline 6, <0.3, -1.2>, <0.6, -0.9>, <0.9, -0.2>, <0.4, 0.3>, <0.5, 0.8>, <0.3, 1> } #break
  #case (12) lathe { bezier_spline 4, <0.2, -0.9>, <1.3, -0.5>, <0.1, 0.3>, <0.5, 0.9> } #break
  #case (13) prism { -0.7, 0.6, 6, <-0.8, -0.6>, <0.7, -0.7>, <0.9, 0.4>, <0, 0.9>, <-0.6, 0.5>, <-0.8, -0.6>
                     rotate <15, 20, 0> } #break
  #case (14) prism { conic_sweep linear_spline 0, 1, 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>
                     rotate 180*x translate 0.9*y } #break
  #case (15) sphere_sweep { linear_spline 3, <-0.9, -0.6, 0>, 0.3, <0, 0.6, 0.2>, 0.4, <0.9, -0.4, -0.3>, 0.25 } #break
  #case (16) sphere_sweep { b_spline 6, <-1.5, -1, 0>, 0.3, <-1, 0, 0.2>, 0.3, <-0.2, 0.7, -0.3>, 0.4, <0.4, -0.6, 0>, 0.3,
                            <1, 0.4, 0.4>, 0.25, <1.5, 1, 0>, 0.3 } #break
  #case (17) ovus { 0.8, 0.45 translate -0.3*y } #break
  #case (18) mesh { #for (I, 0, 23) #if (mod(I, 5) < 4 & I < 19)
               triangle { Net(I), Net(I + 1), Net(I + 5) } triangle { Net(I + 1), Net(I + 6), Net(I + 5) } #end #end
               scale 0.6 translate -0.3*y } #break
  #case (19) mesh2 { vertex_vectors { 4, <1, 1, 1>, <-1, -1, 1>, <-1, 1, -1>, <1, -1, -1> }
                     normal_vectors { 4, <1, 1, 1>, <-1, -1, 1>, <-1, 1, -1>, <1, -1, -1> }
                     face_indices { 4, <0, 1, 2>, <0, 3, 1>, <0, 2, 3>, <1, 3, 2> } scale 0.9 } #break
  #case (20) polygon { 7, <-0.9, -0.7>, <0.9, -0.8>, <0.2, 0>, <0.8, 0.9>, <-0.5, 0.8>, <-0.2, 0.1>, <-0.9, -0.7> } #break
  #case (21) bicubic_patch { type 1 flatness 0 u_steps 4 v_steps 4
               #for (J, 0, 3) #for (I, 0, 3) <I - 1.5, 0.7*sin(1.3*I + J), J - 1.5>*0.7 #if (I + J < 6) , #end #end #end } #break
  #case (22) height_field { function 24, 24 { 0.5 + 0.4*sin(9*x)*cos(7*y) } translate <-0.5, -0.6, -0.5> scale <2.2, 1.2, 2.2> } #break
  #case (23) julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 6 precision 20 } #break
  #case (24) isosurface { function { x*x + y*y + z*z - 0.8 + 0.15*sin(9*x)*sin(9*y)*sin(9*z) } accuracy 1e-5
                          max_gradient 6 contained_by { sphere { 0, 1.2 } } } #break
  #case (25) parametric { function { u } function { 0.5*sin(2*u)*cos(3*v) } function { v }
                          <-1, -1>, <1, 1> contained_by { box { -1.2, 1.2 } } precompute 14 x, y, z max_gradient 2
                          accuracy 0.001 } #break
  #case (26) text { ttf "cyrvetic.ttf" "Ray" 0.3, 0 translate <-0.8, -0.4, 0> scale 1.1 rotate 15*y } #break
  #case (27) difference { box { -0.9, 0.9 } sphere { <0.4, 0.5, -0.9>, 0.8 } cylinder { -2*x, 2*x, 0.4 } } #break
  #case (28) intersection { #for (I, 0, 11) plane { vrotate(y, <31*I, 47*I, 73*I>), 0.8 } #end } #break
  #case (29) merge { sphere { -0.4*x, 0.7 } sphere { 0.5*x, 0.7 } torus { 0.9, 0.2 }
                     texture { pigment { rgbt <0.7, 0.9, 0.8, 0.8> } finish { specular 0.4 } } interior { ior 1.4 } } #break
  #end
object { Thing
  #if (Shape != 29) texture { pigment { rgb <0.9, 0.75, 0.4> } finish { ambient 0.15 diffuse 0.75 } } #end
  transform Place
}
plane { y, -1
  pigment { checker rgb <0.85, 0.85, 0.8>, rgb <0.5, 0.3, 0.3> scale 0.73 translate 0.11 }
  finish { ambient 0.2 diffuse 0.7 }
  transform Place
}
