// Spotlight: full within radius, 0 beyond falloff (angles to the axis), a smooth cubic between; times cos^tightness of the angle.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -9> look_at <0, 0.4, 0> angle 46 }
light_source { <-3, 5, -2> rgb <1, 0.5, 0.4> spotlight point_at <-2, 0, 0> radius 12 falloff 22 tightness 0 }
light_source { <0, 5, -2> rgb <0.5, 1, 0.5> spotlight point_at <0, 0, 0> radius 20 falloff 20 tightness 0 }
light_source { <3, 5, -2> rgb <0.5, 0.6, 1> spotlight point_at <2.4, 0, 0> radius 5 falloff 40 tightness 10 }
light_source { <0, 20, 10> rgb 0.08 }
plane { y, 0 pigment { rgb 0.9 } finish { ambient 0.02 diffuse 0.9 } }
sphere { <-2, 0.6, 0.3>, 0.6 pigment { rgb 0.9 } }
box { <-0.4, 0, -0.4>, <0.4, 1, 0.4> pigment { rgb 0.9 } rotate y * 30 }
cone { <2.4, 0, 0>, 0.6, <2.4, 1.4, 0>, 0 pigment { rgb 0.9 } }
