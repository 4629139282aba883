// Transformations: P' = P·M with M the product of the statements in their order; a ray is carried back by M^-1 (its direction is not
// normalised, so t stays valid), a normal forth by the transpose of M^-1. Rotations are left-handed, about x, then y, then z.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.16, 0.2, 0.28> }
camera { location <0, 3.5, -10> look_at <0, 0.7, 0> angle 42 }
light_source { <-5, 9, -9> rgb 1 }
#declare Piece = union {
  box { <-0.5, 0, -0.3>, <0.5, 1, 0.3> }
  sphere { <0, 1, 0>, 0.45 pigment { rgb <0.9, 0.8, 0.4> } }
  cylinder { <0, 0.5, 0>, <0.9, 0.5, 0>, 0.15 }
  pigment { rgb <0.75, 0.35, 0.3> } finish { phong 0.5 }
}
object { Piece translate <-3.4, 0, 0> }
object { Piece rotate <0, 60, 0> translate <-1.7, 0, 0> }
object { Piece rotate <20, 30, 40> translate <0.1, 0.2, 0> }
object { Piece scale <1.4, 0.7, 1> translate <2, 0, 0> }
object { Piece matrix <1, 0, 0, 0.5, 1, 0, 0, 0, 1, 3.5, 0, 0.5> }
object { Piece scale <1, -1, 1> translate <-2.6, 1.4, 3> }
#declare Turn = transform { rotate y * 45 scale 0.8 }
object { Piece transform { Turn translate <0, 0.2, -3> } }
object { Piece transform { Turn inverse } translate <2.4, 0, -2.6> }
plane { y, 0 pigment { checker rgb 0.75, rgb 0.6 scale 0.8 } }
