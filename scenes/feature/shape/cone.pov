// cone: two ends and two radii; open; with an apex; radii of opposite sign give a double cone.
// lute scenes/feature/shape/cone.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

cone { <-1.6, -0.8, 0>, 0.6, <-1.3, 0.8, 0>, 0.25 }
cone { <-0.8, 0.4, -0.6>, 0.5, <0, -0.4, 0.6>, 0.2 open texture { pigment { rgb <1, 0.8, 0.5> } } interior_texture { pigment { rgb <0.3, 0.4, 1> } } }
cone { <0.7, -0.8, 0>, 0.5, <0.7, 0.8, 0>, 0 }
cone { <1.6, -0.8, 0>, 0.4, <1.6, 0.8, 0>, -0.3 }
