// A dense scene for `lute-compare speed bench/scene`: quaternion julia fractals, 8 x 6 x 3. The lights stand behind the camera: where
// light grazes a fractal, POV-Ray's hits shade themselves here and there.
#declare Light_Place = array[2] { <-2, 3, -40>, <3, 0, -40> }
#include "field.inc"
#declare Shape = julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 20 scale 0.7 }
Field(Shape, 8, 6)
