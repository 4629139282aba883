// bounded_by: rays that miss it miss the object; clipped_by { bounded_by } clips with the same.
// lute scenes/feature/csg/bounded_by.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

union { sphere { <-0.4, 0, 0>, 0.6 } sphere { <0.4, 0, 0>, 0.6 } bounded_by { box { <-1.1, -0.7, -0.7>, <1.1, 0.7, 0.7> } } translate -1.1 * x }
union { sphere { <-0.4, 0, 0>, 0.6 } sphere { <0.4, 0, 0>, 0.6 } bounded_by { box { <-0.9, -0.4, -0.7>, <0.9, 0.4, 0.7> } } clipped_by { bounded_by }
  texture { pigment { rgb <1, 0.8, 0.5> } } interior_texture { pigment { rgb <0.3, 0.4, 1> } } translate 1.1 * x }
