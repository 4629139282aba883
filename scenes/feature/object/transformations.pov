// translate, rotate, scale, matrix and transform, with the texture moved along.
// lute scenes/feature/object/transformations.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 1.5, -6> right 4 / 3 * x look_at 0 angle 38 }
light_source { <-4, 6, -8> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.7> } }
#macro Ball(X, Finish) sphere { <X, 0, 0>, 0.6 pigment { rgb <1, 0.6, 0.3> } finish { Finish } } #end
#declare Plain = finish { ambient 0.1 diffuse 0.6 }

#declare Turn = transform { rotate 30 * z scale <1, 0.6, 1> }
#declare Brick = box { -0.4, 0.4 pigment { checker rgb <0.9, 0.4, 0.3>, rgb 1 scale 0.2 } }
object { Brick rotate <20, 30, 0> translate -1.6 * x }
object { Brick matrix <1, 0.4, 0, 0, 1, 0, 0.3, 0, 1, -0.5, 0, 0> }
object { Brick transform { Turn } translate 0.5 * x }
object { Brick transform { Turn inverse } translate 1.6 * x }
