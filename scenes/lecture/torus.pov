// Ray and torus: (|P|^2 + R^2 - r^2)^2 = 4R^2 (x^2 + z^2) is a quartic in t with up to four hits.
// A ring, one seen edge-on, one whose tube is wider than its radius (spindle), and one stretched.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.15, 0.18, 0.25> }
camera { location <0, 3, -9> look_at <0, 0.5, 0> angle 40 }
light_source { <-5, 8, -8> rgb 1 }
torus { 1, 0.35 pigment { rgb <0.85, 0.35, 0.25> } finish { phong 0.6 } rotate x * -40 translate <-2.4, 1, 0> }
torus { 0.9, 0.15 pigment { rgb <0.9, 0.8, 0.3> } finish { phong 0.6 } rotate x * 90 rotate y * 80 translate <0, 1, 0> }
torus { 0.4, 0.6 pigment { rgb <0.4, 0.65, 0.45> } finish { phong 0.6 } translate <0.8, 0.6, -2> }
torus { 0.8, 0.3 sturm pigment { rgb <0.4, 0.5, 0.9> } finish { phong 0.6 } scale <1, 2, 1> rotate z * 50 translate <2.6, 1, 0> }
plane { y, -0.4 pigment { rgb 0.7 } }
