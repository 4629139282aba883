// A dense scene for `lute-compare speed bench/scene`: texts of a font with serifs, 9 x 9 x 3.
#include "field.inc"
#declare Shape = text { ttf "timrom.ttf" "Lute" 0.3, 0 translate <-0.95, -0.3, -0.15> }
Field(Shape, 9, 9)
