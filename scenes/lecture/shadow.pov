// A shadow test: is there any hit between the point and the light, 0 < t < distance? The first found ends the search. An object
// behind the light throws no shadow, no_shadow objects never do, a filter colours the light, and shadowless lights do not ask.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 5, -9> look_at <0, 0.6, 0> angle 45 }
light_source { <-3, 5, -3> rgb 0.8 }
light_source { <6, 6, -4> rgb <0.15, 0.15, 0.25> shadowless }
plane { y, 0 pigment { rgb 0.85 } finish { ambient 0.1 diffuse 0.7 } }
sphere { <-1.6, 1, 0>, 0.8 pigment { rgb <0.9, 0.4, 0.3> } }
box { <0.2, 0, -0.5>, <1, 1.6, 0.3> pigment { rgb <0.3, 0.6, 0.4> } no_shadow }
sphere { <2.4, 0.9, 0.5>, 0.9 pigment { rgbf <0.95, 0.7, 0.2, 0.8> } }                   // coloured shadow
sphere { <-3, 6.5, -3>, 0.7 pigment { rgb <0.9, 0.9, 0.2> } }                          // behind the light
cylinder { <-0.4, 0, -2>, <-0.4, 1.4, -2>, 0.15 pigment { rgbt <0.4, 0.5, 0.9, 0.5> } }  // half shadow
