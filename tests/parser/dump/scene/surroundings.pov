#version 3.7;
global_settings { assumed_gamma srgb ambient_light 2 }
background { srgb <0.5, 0.5, 1> }
sky_sphere { pigment { gradient y color_map { [0 rgb 1] [1 rgb z] } } rotate 10*x }
fog { fog_type 2 distance 10 rgb 0.5 turbulence 0.2 }
rainbow { angle 42 width 5 direction z color_map { [0 rgb x] [1 rgb z] } arc_angle 120 falloff_angle 30 }
media { scattering { 5, 0.1 eccentricity 0.3 } density { spherical } }
sphere { 0, 1 interior { ior 1.5 fade_distance 2 fade_power 1001 } }
