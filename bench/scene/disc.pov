// A dense scene for `lute-compare speed bench/scene`: discs with holes, 40 x 30 x 3.
#include "field.inc"
#declare Shape = disc { 0, y, 1, 0.4 }
Field(Shape, 40, 30)
