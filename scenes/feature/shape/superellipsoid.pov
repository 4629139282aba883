// superellipsoid: roundness east-west and north-south, from box to star.
// lute scenes/feature/shape/superellipsoid.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

superellipsoid { <0.25, 0.25> scale 0.5 rotate <20, 30, 0> translate <-1.5, 0.6, 0> }
superellipsoid { <1, 0.2> scale 0.5 rotate -60 * x translate <0, 0.6, 0> }
superellipsoid { <0.2, 1> scale 0.5 rotate <-60, 20, 0> translate <1.5, 0.6, 0> }
superellipsoid { <1, 1> scale 0.5 translate <-1.5, -0.7, 0> }
superellipsoid { <1.6, 1.4> scale 0.5 rotate <20, 30, 0> translate <0, -0.7, 0> }
superellipsoid { <2.5, 0.7> scale 0.6 rotate -50 * x translate <1.5, -0.7, 0> }
