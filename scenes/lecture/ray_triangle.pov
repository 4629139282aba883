// Ray and triangle: first the plane of the triangle, n = (B - A) x (C - A), t = n·(A - O) / (n·D); then the barycentric
// coordinates of the point, P = A + u(B - A) + v(C - A): a hit if u >= 0, v >= 0 and u + v <= 1.
// A fan that shares edges (no crack may show), one seen from behind, and one that is a needle.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 0.15 }
camera { location <0, 1, -8> look_at <0, 0.5, 0> angle 50 }
light_source { <-5, 6, -10> rgb 1 }
#declare N = 8;
#for (I, 0, N - 1)
  #declare A0 = 2 * pi * I / N;
  #declare A1 = 2 * pi * (I + 1) / N;
  triangle {
    <-1.2, 0.8, 0.6>, <-1.2 + 1.8 * cos(A0), 0.8 + 1.8 * sin(A0), 0>, <-1.2 + 1.8 * cos(A1), 0.8 + 1.8 * sin(A1), 0>
    pigment { rgb <0.2 + 0.7 * I / N, 0.5, 0.9 - 0.7 * I / N> }
  }
#end
triangle { <1.4, 2.4, 1>, <3.6, 2.2, -0.5>, <2.4, 0.4, 0> pigment { rgb <0.9, 0.8, 0.2> } }
triangle { <1.2, -0.2, 0>, <2.6, -1.2, 0.4>, <3.6, 0.2, -1> pigment { rgb <0.3, 0.8, 0.5> } }
triangle { <-3.2, -1.6, 0>, <3.4, -1.62, 0>, <3.4, -1.45, 0> pigment { rgb <0.9, 0.4, 0.3> } }
