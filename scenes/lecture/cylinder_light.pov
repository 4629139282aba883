// Cylinder light: as a spotlight, but radius and falloff are distances from the axis; the rays still leave from the one point.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -9> look_at <0, 0.4, 0> angle 46 }
light_source { <-3, 5, -3> rgb <1, 0.6, 0.4> cylinder point_at <-2, 0, 0> radius 0.7 falloff 1.2 tightness 0 }
light_source { <3, 5, -3> rgb <0.5, 0.7, 1> cylinder point_at <1.5, 0, 0.5> radius 1.2 falloff 1.3 tightness 5 }
light_source { <0, 20, 10> rgb 0.1 }
plane { y, 0 pigment { rgb 0.9 } finish { ambient 0.02 diffuse 0.9 } }
sphere { <-2, 0.6, 0>, 0.6 pigment { rgb 0.9 } }
box { <-0.4, 0, -0.4>, <0.4, 1.2, 0.4> pigment { rgb 0.9 } rotate y * 30 translate <1.5, 0, 0.5> }
