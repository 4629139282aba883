// checker: the cell of P is floor(x) + floor(y) + floor(z); even cells take the first colour. Colour pairs, a scaled and rotated one,
// and one of pigments.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.5, 0.6, 0.75> }
camera { location <0, 3, -8> look_at <0, 0.7, 0> angle 46 }
light_source { <-5, 9, -7> rgb 1 }
plane { y, -0.001 pigment { checker rgb <0.85, 0.8, 0.7>, rgb <0.35, 0.25, 0.2> } }
sphere { <-2, 1, 0>, 1 pigment { checker rgb <0.9, 0.3, 0.2>, rgb 0.9 scale 0.3 translate 0.013 } }
box { -0.8, 0.8 pigment { checker rgb <0.3, 0.6, 0.4>, rgb <0.9, 0.85, 0.4> rotate <30, 20, 10> scale 0.37 } rotate y * 30 translate <0.6, 0.8, 0.3> }
sphere { <2.8, 1, 0>, 0.9 pigment { checker pigment { gradient y color_map { [0 rgb 0][1 rgb 1] } scale 0.2 }, pigment { rgb <0.3, 0.4, 0.9> } scale 0.5 translate 0.017 } }
