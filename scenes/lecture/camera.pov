// The left-handed camera: x to the right, y up, z into the picture. A pixel's ray is D = direction + u·right + v·up with u, v in
// -1/2 ... 1/2. The red rod points along +x, the green along +y, the blue along +z; the camera is tilted by sky and looks down.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.75, 0.8, 0.85> }
camera { location <3.5, 3, -5> sky <0.15, 1, 0> right x * 4 / 3 angle 38 look_at <0.6, 0.6, 0.6> }
light_source { <6, 9, -8> rgb 1 }
#macro Rod(Axis, Colour)
  union {
    cylinder { 0, 1.7 * Axis, 0.08 }
    cone { 1.7 * Axis, 0.2, 2.2 * Axis, 0 }
    pigment { rgb Colour }
  }
#end
Rod(x, <0.9, 0.15, 0.1>)
Rod(y, <0.1, 0.7, 0.15>)
Rod(z, <0.15, 0.3, 0.95>)
sphere { 0, 0.2 pigment { rgb 0.95 } }
plane { y, -0.3 pigment { checker rgb 0.85, rgb 0.7 } }
