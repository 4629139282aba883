// A scene for `lute-compare speed bench/scene`: parametric surfaces, 3 x 2 x 3. They are small, coarse and far apart: POV-Ray needs minutes for a
// picture full of them.
#include "field.inc"
#declare Shape = parametric { function { (0.6 + 0.25 * cos(v)) * cos(u) }, function { 0.25 * sin(v) }, function { (0.6 + 0.25 * cos(v)) * sin(u) }
  <0, 0>, <2 * pi, 2 * pi> contained_by { box { <-0.9, -0.3, -0.9>, <0.9, 0.3, 0.9> } } max_gradient 1.5 accuracy 0.05 precompute 12 x, y, z scale 0.4 }
Field(Shape, 3, 2)
