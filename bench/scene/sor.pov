// A dense scene for `lute-compare speed bench/scene`: surfaces of revolution, 16 x 12 x 3. Their axes stay within 50 degrees of the view:
// across an axis POV-Ray's closed form loses hits.
#include "field.inc"
#declare Shape = sor { 7, <0, -1>, <0.5, -0.8>, <0.7, -0.4>, <0.25, 0.2>, <0.4, 0.6>, <0.45, 0.8>, <0.4, 1> }
Facing_Field(Shape, 16, 12)
