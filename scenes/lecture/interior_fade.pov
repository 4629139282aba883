// Attenuation inside a body: with fade_distance d0, fade_power p and fade_colour the light that crosses a distance d is multiplied by
// 1 / (1 + (d / d0)^p), or coloured; p >= 1000 is the law of Beer and Lambert, exp(-d / d0). Thick parts are darker.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
background { rgb <0.75, 0.8, 0.9> }
camera { location <0, 2, -8> look_at <0, 0.9, 0> angle 44 }
light_source { <-5, 9, -6> rgb 1 }
plane { y, 0 pigment { checker rgb 0.95, rgb 0.6 scale 0.8 } finish { ambient 0.2 diffuse 0.7 } }
sphere { <-2.4, 1, 0>, 1 pigment { rgbf 1 } finish { diffuse 0 ambient 0 } interior { ior 1.3 fade_distance 0.7 fade_power 2 } }
sphere { <0, 1, 0>, 1 pigment { rgbf 1 } finish { diffuse 0 ambient 0 } interior { ior 1.3 fade_distance 0.6 fade_power 1001 fade_color rgb <0.2, 0.7, 0.4> } }
box { <1.5, 0.01, -0.8>, <3.3, 1.6, 0.8> pigment { rgbf 1 } finish { diffuse 0 ambient 0 } interior { ior 1.1 fade_distance 1 fade_power 1 fade_color rgb <0.8, 0.3, 0.2> } rotate y * 20 }
