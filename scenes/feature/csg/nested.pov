// CSG in CSG in CSG, each level moved.
// lute scenes/feature/csg/nested.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

#declare Bead = difference { sphere { 0, 0.5 } cylinder { -y, y, 0.2 } }
#declare Pair = union { object { Bead translate -0.4 * x } object { Bead rotate 90 * z translate 0.4 * x } }
#declare Cut = intersection { object { Pair scale 1.4 } box { <-1.2, -0.5, -0.4>, <1.2, 0.5, 1> rotate 15 * z } }
difference { object { Cut rotate 10 * y } object { Pair scale 0.7 translate <0, 0.5, -0.4> pigment { rgb <1, 0.3, 0.2> } } rotate <10, 20, 0> scale 1.3 }
