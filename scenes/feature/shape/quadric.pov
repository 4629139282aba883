// quadric: ellipsoid, cone, cylinder, hyperboloid and paraboloid, each cut by a box.
// lute scenes/feature/shape/quadric.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

#declare Cut = box { -0.6, 0.6 }
quadric { <3, 5, 8>, <0, 0, 0>, <0, 0, 0>, -1 translate <-1.8, 0.7, 0> }
quadric { <1, -1, 1>, <0, 0, 0>, <0, 0, 0>, 0 clipped_by { Cut } translate <-0.6, 0.7, 0> }
quadric { <1, 0, 1>, <0, 0, 0>, <0, 0, 0>, -0.2 clipped_by { Cut } rotate 20 * z translate <0.6, 0.7, 0> }
quadric { <1, -1, 1>, <0, 0, 0>, <0, 0, 0>, -0.1 clipped_by { Cut } translate <1.8, 0.7, 0> }
quadric { <1, -1, 1>, <0, 0, 0>, <0, 0, 0>, 0.1 clipped_by { Cut } translate <-1.4, -0.7, 0> }
intersection { quadric { <1, 0, 1>, <0, 0, 0>, <0, -0.5, 0>, 0 } box { <-0.6, 0, -0.6>, 0.6 } translate <0, -0.7, 0> }
quadric { <1, 0, -1>, <0, 0, 0>, <0, 1, 0>, 0 clipped_by { Cut } rotate -30 * x translate <1.4, -0.7, 0> }
