// Ray and plane, in Hesse's normal form: the plane holds every point P with n·P = d (n of length 1).
// The ray P(t) = O + tD meets it at t = (d - n·O) / (n·D); n·D = 0: the ray is parallel, no hit; t <= 0: behind the eye.
// A floor, two walls of different slope and a plane behind the eye; above the horizon every ray misses and the background shows.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.30, 0.45, 0.65> }
camera { location <0, 2, -7> look_at <0, 2.2, 0> angle 70 }
light_source { <-4, 8, -6> rgb 1 }
plane { y, 0 pigment { rgb <0.75, 0.70, 0.60> } finish { ambient 0.1 diffuse 0.8 } }
plane { <1, 0.6, -0.25>, -5 pigment { rgb <0.70, 0.25, 0.20> } finish { ambient 0.1 diffuse 0.8 } }
plane { <-1, 0.9, -0.05>, -6 pigment { rgb <0.25, 0.55, 0.35> } finish { ambient 0.1 diffuse 0.8 } }
plane { z, -9 pigment { rgb <1, 0, 1> } }
