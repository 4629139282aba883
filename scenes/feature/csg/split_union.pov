// split_union: a union at the top is split into its parts; off keeps it whole: the last of equal depths shows.
// lute scenes/feature/csg/split_union.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

union { box { <-1.8, -0.8, 0>, <-0.4, 0.8, 1> pigment { rgb <1, 0.3, 0.2> } } box { <-1.5, -0.5, 0>, <-0.1, 0.5, 1> pigment { rgb <0.3, 0.4, 1> } } }
union { box { <0.1, -0.8, 0>, <1.5, 0.8, 1> pigment { rgb <1, 0.3, 0.2> } } box { <0.4, -0.5, 0>, <1.8, 0.5, 1> pigment { rgb <0.3, 0.4, 1> } } split_union off }
