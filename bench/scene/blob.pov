// A dense scene for `lute-compare speed bench/scene`: blobs of 12 components, 12 x 9 x 3.
#include "field.inc"
#declare Shape = blob {
  threshold 0.4
  #for (I, 0, 9) sphere { 0.6 * vrotate(x, <0, 36 * I, 20 * mod(I, 3)>), 0.45, 1 } #end
  cylinder { -0.6 * y, 0.6 * y, 0.3, 1 }
  sphere { <0.4, 0.3, 0>, 0.4, -0.7 }
}
Field(Shape, 12, 9)
