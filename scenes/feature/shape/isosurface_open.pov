// isosurface contained by a sphere, open: the cut is a hole.
// lute scenes/feature/shape/isosurface_open.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

isosurface { function { sin(3 * x) + cos(3 * y) + sin(3 * z) } open max_gradient 5.2 contained_by { sphere { 0, 1.3 } } accuracy 0.0005
  texture { pigment { rgb <1, 0.8, 0.5> } } interior_texture { pigment { rgb <0.3, 0.4, 1> } } rotate <10, 30, 0> }
