// blob with sturm and without hierarchy; the old component syntax.
// lute scenes/feature/shape/blob_sturm.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

blob {
  threshold 0.5
  component 1, 0.9, <-0.9, 0, 0>
  component 1, 0.9, <0.1, 0.2, 0>
  component -0.8, 0.6, <-0.3, 0.2, -0.5>
  cylinder { <0.4, -0.8, 0>, <1.2, 0.8, 0.3>, 0.6, strength 1.5 }
  sturm hierarchy off
}
