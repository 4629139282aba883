// Transparency: filter f passes light multiplied by the colour, transmit t passes it unchanged: what is behind comes through as
// colour·f + t, the surface keeps the rest, 1 - f - t. Panes of rising filter in front, of rising transmit behind.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
background { rgb 1 }
camera { location <0, 1.6, -8> look_at <0, 1, 0> angle 45 }
light_source { <-6, 8, -8> rgb 1 }
plane { y, 0 pigment { checker rgb <0.9, 0.9, 0.7>, rgb <0.3, 0.35, 0.5> } finish { ambient 0.2 diffuse 0.6 } }
plane { z, 6 pigment { checker rgb 0.9, rgb 0.4 } finish { ambient 0.3 diffuse 0.5 } }
#for (I, 0, 4)
  box { <-0.55, 0, -0.05>, <0.55, 0.9, 0.05> pigment { rgbf <0.9, 0.3, 0.2, I / 4> } translate <-2.6 + 1.3 * I, 0.05, -1> }
  box { <-0.55, 0, -0.05>, <0.55, 0.9, 0.05> pigment { rgbt <0.2, 0.5, 0.9, I / 4> } translate <-2.6 + 1.3 * I, 1.15, 0> }
#end
sphere { <0, 0.5, -2.6>, 0.4 pigment { rgbft <0.3, 0.9, 0.4, 0.4, 0.4> } finish { phong 0.8 } }
