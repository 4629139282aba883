// Union: a point is inside when it is inside any member; every surface of every member stays, also those inside another (seen here through
// the filtering member). Members may carry textures of their own.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
background { rgb <0.2, 0.24, 0.3> }
camera { location <0, 2.4, -7> look_at <0, 0.8, 0> angle 42 }
light_source { <-5, 8, -8> rgb 1 }
union {
  sphere { <-1.6, 0.9, 0>, 0.9 }
  box { <-2, 0, -0.5>, <-0.6, 0.6, 0.5> pigment { rgb <0.9, 0.8, 0.3> } }
  cylinder { <-1.6, 0.9, 0>, <-1.6, 2.3, 0>, 0.3 }
  pigment { rgb <0.8, 0.35, 0.25> } finish { phong 0.4 }
}
union {
  sphere { <1.1, 0.9, 0>, 0.9 }
  sphere { <2, 0.9, 0>, 0.9 }
  pigment { rgbf <0.6, 0.8, 1, 0.7> } finish { phong 0.4 }
}
plane { y, 0 pigment { checker rgb 0.8, rgb 0.6 } }
