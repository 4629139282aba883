// Total internal reflection: when eta^2 (1 - c^2) > 1 there is no refracted ray and all light is reflected inside.
// A prism seen through its hypotenuse, a block of glass with objects below it, and a ball of high index.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
background { rgb <0.6, 0.7, 0.85> }
camera { location <0, 1.6, -7> look_at <0, 0.8, 0> angle 45 }
light_source { <-5, 9, -8> rgb 1 }
plane { y, 0 pigment { checker rgb <0.95, 0.9, 0.6>, rgb <0.2, 0.35, 0.3> scale 0.6 } finish { ambient 0.2 diffuse 0.6 } }
intersection {
  plane { -y, 0 }
  plane { x, 0 rotate z * 45 translate x * 0.9 }
  plane { -x, 0 rotate z * -45 translate x * -0.9 }
  plane { z, 1 }
  plane { -z, 1 }
  pigment { rgbf <0.95, 1, 1, 0.98> } finish { diffuse 0.02 specular 0.4 } interior { ior 1.55 }
  scale 1.4 rotate y * 30 translate <-1.7, 0.01, 0>
}
box { <0.4, 0.01, -1>, <2.6, 1.1, 0.6> pigment { rgbf <1, 0.95, 0.95, 0.98> } finish { diffuse 0.02 specular 0.4 } interior { ior 1.5 } rotate y * -15 }
sphere { <0.2, 0.4, -2.2>, 0.4 pigment { rgbf 0.98 } finish { diffuse 0.02 } interior { ior 2.2 } }
sphere { <3.3, 0.5, 1.5>, 0.5 pigment { rgb <0.8, 0.2, 0.3> } }
