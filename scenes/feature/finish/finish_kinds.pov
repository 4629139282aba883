// Finishes of every kind, opaque and clear: odd exponents, negative amounts, albedo, metallic, fresnel, conserve_energy.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <6,3.5,-10> look_at <6,3.5,0> right 12*x up 7*y }
light_source { <-20,30,-40> rgb 1 }
light_source { <30,-5,-20> rgb <0.3,0.2,0.4> }
background { rgb <0.1,0.2,0.3> }
plane{y,-1 pigment{checker rgb 1 rgb 0.3}} plane{z,5 pigment{checker rgb x rgb y}}
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{irid{0.5}} interior{ior 1.5} translate <0.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{irid{0.8 thickness 0.5 turbulence 0.3}} interior{ior 1.5} translate <1.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{irid{0.4 thickness 2}} interior{ior 1.5} translate <2.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{brilliance 0} interior{ior 1.5} translate <3.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{brilliance 3} interior{ior 1.5} translate <4.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{brilliance 0.5} interior{ior 1.5} translate <5.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{brilliance -1} interior{ior 1.5} translate <6.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{diffuse albedo 0.7 brilliance 4} interior{ior 1.5} translate <7.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{phong albedo 0.8 phong_size 20} interior{ior 1.5} translate <8.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{specular albedo 0.8 roughness 0.05} interior{ior 1.5} translate <9.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{specular 1 roughness 0.001} interior{ior 1.5} translate <10.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{specular 0.7 roughness 1} interior{ior 1.5} translate <11.5,0.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{phong 1 phong_size 1} interior{ior 1.5} translate <0.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{phong 1 phong_size 200 metallic} interior{ior 1.5} translate <1.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{specular 0.8 metallic 0.5} interior{ior 1.5} translate <2.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{specular 0.8 metallic 2 roughness 0.02} interior{ior 1.5} translate <3.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{diffuse 0.5,0.8} interior{ior 1.5} translate <4.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{emission 0.3} interior{ior 1.5} translate <5.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{emission <0.2,0.5,0.1>} interior{ior 1.5} translate <6.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{ambient <1,0,0.5>} interior{ior 1.5} translate <7.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{reflection 0.5} interior{ior 1.5} translate <8.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{reflection{0.1,0.9}} interior{ior 1.5} translate <9.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{reflection{0.1,0.9 falloff 3}} interior{ior 1.5} translate <10.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{reflection{rgb <1,0.5,0>, rgb <0,0.5,1>}} interior{ior 1.5} translate <11.5,1.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{reflection{0,1 fresnel} } interior{ior 1.5} translate <0.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{reflection{0.6 metallic}} interior{ior 1.5} translate <1.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{reflection{0.6 metallic 0.5} metallic} interior{ior 1.5} translate <2.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{reflection 0.5 reflection_exponent 2} interior{ior 1.5} translate <3.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{reflection{0.8 exponent 0.5}} interior{ior 1.5} translate <4.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{reflection{0.5 metallic} conserve_energy} interior{ior 1.5} translate <5.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{conserve_energy reflection 0.5} interior{ior 1.5} translate <6.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{reflection -0.5} interior{ior 1.5} translate <7.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{diffuse 0 ambient 0} interior{ior 1.5} translate <8.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{diffuse -0.5} interior{ior 1.5} translate <9.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{phong -1} interior{ior 1.5} translate <10.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{specular 0.5 specular 0.7} interior{ior 1.5} translate <11.5,2.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{metallic} interior{ior 1.5} translate <0.5,3.5,0> }
sphere { 0, 0.47 pigment{rgb <0.8,0.6,0.3>} finish{crand 0} interior{ior 1.5} translate <1.5,3.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{irid{0.5}} interior{ior 1.4} translate <2.5,3.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{irid{0.8 thickness 0.5 turbulence 0.3}} interior{ior 1.4} translate <3.5,3.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{irid{0.4 thickness 2}} interior{ior 1.4} translate <4.5,3.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{brilliance 0} interior{ior 1.4} translate <5.5,3.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{brilliance 3} interior{ior 1.4} translate <6.5,3.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{brilliance 0.5} interior{ior 1.4} translate <7.5,3.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{brilliance -1} interior{ior 1.4} translate <8.5,3.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{diffuse albedo 0.7 brilliance 4} interior{ior 1.4} translate <9.5,3.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{phong albedo 0.8 phong_size 20} interior{ior 1.4} translate <10.5,3.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{specular albedo 0.8 roughness 0.05} interior{ior 1.4} translate <11.5,3.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{specular 1 roughness 0.001} interior{ior 1.4} translate <0.5,4.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{specular 0.7 roughness 1} interior{ior 1.4} translate <1.5,4.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{phong 1 phong_size 1} interior{ior 1.4} translate <2.5,4.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{phong 1 phong_size 200 metallic} interior{ior 1.4} translate <3.5,4.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{specular 0.8 metallic 0.5} interior{ior 1.4} translate <4.5,4.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{specular 0.8 metallic 2 roughness 0.02} interior{ior 1.4} translate <5.5,4.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{diffuse 0.5,0.8} interior{ior 1.4} translate <6.5,4.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{emission 0.3} interior{ior 1.4} translate <7.5,4.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{emission <0.2,0.5,0.1>} interior{ior 1.4} translate <8.5,4.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{ambient <1,0,0.5>} interior{ior 1.4} translate <9.5,4.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{reflection 0.5} interior{ior 1.4} translate <10.5,4.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{reflection{0.1,0.9}} interior{ior 1.4} translate <11.5,4.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{reflection{0.1,0.9 falloff 3}} interior{ior 1.4} translate <0.5,5.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{reflection{rgb <1,0.5,0>, rgb <0,0.5,1>}} interior{ior 1.4} translate <1.5,5.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{reflection{0,1 fresnel} } interior{ior 1.4} translate <2.5,5.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{reflection{0.6 metallic}} interior{ior 1.4} translate <3.5,5.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{reflection{0.6 metallic 0.5} metallic} interior{ior 1.4} translate <4.5,5.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{reflection 0.5 reflection_exponent 2} interior{ior 1.4} translate <5.5,5.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{reflection{0.8 exponent 0.5}} interior{ior 1.4} translate <6.5,5.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{reflection{0.5 metallic} conserve_energy} interior{ior 1.4} translate <7.5,5.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{conserve_energy reflection 0.5} interior{ior 1.4} translate <8.5,5.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{reflection -0.5} interior{ior 1.4} translate <9.5,5.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{diffuse 0 ambient 0} interior{ior 1.4} translate <10.5,5.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{diffuse -0.5} interior{ior 1.4} translate <11.5,5.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{phong -1} interior{ior 1.4} translate <0.5,6.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{specular 0.5 specular 0.7} interior{ior 1.4} translate <1.5,6.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{metallic} interior{ior 1.4} translate <2.5,6.5,0> }
sphere { 0, 0.47 pigment{rgbf <0.8,0.6,0.3,0.6>} finish{crand 0} interior{ior 1.4} translate <3.5,6.5,0> }
