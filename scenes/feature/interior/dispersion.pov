// dispersion: colours are bent by different amounts.
// lute scenes/feature/interior/dispersion.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 1.5, -6> right 4 / 3 * x look_at 0 angle 38 }
light_source { <-4, 6, -8> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.7> } }
#macro Ball(X, Finish) sphere { <X, 0, 0>, 0.6 pigment { rgb <1, 0.6, 0.3> } finish { Finish } } #end
#declare Plain = finish { ambient 0.1 diffuse 0.6 }

sphere { <-1.4, 0, 0>, 0.6 pigment { rgbf <1, 1, 1, 0.9> } finish { ambient 0 diffuse 0.1 specular 0.5 } interior { ior 1.5 dispersion 1.05 } }
sphere { <0, 0, 0>, 0.6 pigment { rgbf <1, 1, 1, 0.9> } finish { ambient 0 diffuse 0.1 specular 0.5 } interior { ior 1.5 dispersion 1.1 dispersion_samples 15 } }
sphere { <1.4, 0, 0>, 0.6 pigment { rgbf <1, 1, 1, 0.9> } finish { ambient 0 diffuse 0.1 specular 0.5 } interior { ior 1.3 dispersion 1.02 dispersion_samples 3 } }
