// blob: spheres and a cylinder that attract, a negative sphere that pushes the surface away, a squeezed component.
// lute scenes/feature/shape/blob.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

blob {
  threshold 0.6
  sphere { <-1, 0, 0>, 1.2, 1 }
  sphere { <0.2, 0.4, 0>, 1, 1.2 }
  cylinder { <0.2, -0.6, 0>, <1.5, 0.5, 0>, 0.7, 1 }
  sphere { <-0.5, 0.3, -0.7>, 0.7, -1.2 }
  sphere { 0, 1, 1 scale <0.4, 1, 0.4> rotate 30 * z translate <-1.6, 0.3, 0> }
}
