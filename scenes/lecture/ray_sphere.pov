// Ray and sphere: |O + tD - C|^2 = r^2 is a quadratic in t, t = -b ± sqrt(b^2 - c) with b = D·(O - C), c = |O - C|^2 - r^2 for
// |D| = 1. Discriminant below 0: miss; 0: the ray touches; else entry and exit, the nearer positive one is seen.
// A row of spheres, one of radius so small that most rays miss, one cut by the picture's edge, one around the eye; the orthographic camera
// of the tangent pair lets whole columns of rays touch: at x = ±1 the ray is tangent.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.1, 0.1, 0.15> }
camera { orthographic location <0, 0, -10> right 8 * x up 6 * y direction z }
light_source { <-8, 9, -14> rgb 1 }
sphere { <-2, 0, 0>, 1 pigment { rgb <0.9, 0.3, 0.25> } finish { phong 0.5 } }       // tangent to the next one
sphere { <0, 0, 0>, 1 pigment { rgb <0.9, 0.75, 0.3> } finish { phong 0.5 } }
sphere { <2, 0, 0>, 1 pigment { rgb <0.35, 0.7, 0.4> } finish { phong 0.5 } }
sphere { <0, 2, 0>, 0.05 pigment { rgb <1, 1, 1> } finish { ambient 1 } }
sphere { <4, -2.5, 1>, 1.3 pigment { rgb <0.4, 0.5, 0.95> } }
sphere { <-2.5, -2, 3>, 0.8 pigment { rgb <0.8, 0.5, 0.9> } scale <1.3, 1, 1> }
sphere { <0, 0, -10>, 40 pigment { rgb <0.2, 0.25, 0.3> } hollow }
