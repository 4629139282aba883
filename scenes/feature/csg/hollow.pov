// hollow: fog is inside too; without it an object keeps the fog out.
// lute scenes/feature/csg/hollow.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

fog { distance 8 rgb <0.9, 0.6, 0.5> }
plane { z, 6 pigment { checker rgb 1, rgb 0 } hollow }
sphere { <-1, 0, 0>, 0.9 pigment { rgbt <0.9, 1, 0.9, 0.9> } hollow }
sphere { <1, 0, 0>, 0.9 pigment { rgbt <0.9, 1, 0.9, 0.9> } }
