// torus whose minor radius is the greater: the surface cuts itself; seen through an opened side.
// lute scenes/feature/shape/torus_spindle.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

difference {
  torus { 0.4, 0.7 rotate -40 * x }
  box { <-2, -2, -2>, <2, 2, 0> rotate 30 * y }
  texture { pigment { rgb <1, 0.8, 0.5> } } interior_texture { pigment { rgb <0.3, 0.4, 1> } }
}
