// Refraction by Snell's law: with eta = n1/n2 and c = -n·D, T = eta·D + (eta·c - sqrt(1 - eta^2 (1 - c^2)))·n.
// Glass, water and diamond spheres, a slab that shifts what is behind it, and a hollow air bubble in glass.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
background { rgb <0.5, 0.65, 0.8> }
camera { location <0, 2, -8> look_at <0, 1, 0> angle 45 }
light_source { <-5, 9, -6> rgb 1 }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.8>, rgb <0.3, 0.2, 0.2> scale 0.7 } finish { ambient 0.15 diffuse 0.7 } }
cylinder { <-4, 0.4, 3>, <4, 0.4, 3>, 0.4 pigment { rgb <0.8, 0.3, 0.2> } }
sphere { <-2.5, 1, 0>, 1 pigment { rgbf <0.95, 1, 0.95, 0.95> } finish { diffuse 0.05 specular 0.5 reflection 0.05 } interior { ior 1.5 } }
sphere { <0, 1, 0>, 1 pigment { rgbf <0.9, 0.95, 1, 0.95> } finish { diffuse 0.05 specular 0.5 } interior { ior 1.33 } }
difference {
  sphere { <2.5, 1, 0>, 1 }
  sphere { <2.5, 1, 0>, 0.7 }
  pigment { rgbf <1, 0.95, 0.9, 0.95> } finish { diffuse 0.05 specular 0.5 } interior { ior 1.5 }
}
box { <-0.7, 0.2, -3.2>, <0.9, 0.9, -2.8> pigment { rgbf 0.95 } finish { diffuse 0.02 } interior { ior 1.6 } rotate y * 25 }
sphere { <0.2, 0.3, -4.2>, 0.25 pigment { rgbf <1, 0.9, 0.6, 0.9> } interior { ior 2.4 } }
