// uv_mapping on mirrored boxes: a negative scale mirrors the map behind a rotation or matrix, not before.
// lute scenes/feature/shape/box_uv.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { finish { ambient 0.2 diffuse 0.7 } }

// u in red, v in green: every point of the map has a colour of its own.
#declare Both = pigment {
  gradient x pigment_map {
    [0 gradient y color_map { [0 rgb <0, 0, 0.3>] [1 rgb <0, 1, 0.3>] }]
    [1 gradient y color_map { [0 rgb <1, 0, 0.3>] [1 rgb <1, 1, 0.3>] }]
  }
}
#declare Brick = box { <-0.5, -0.4, -0.3>, <0.4, 0.4, 0.3> uv_mapping pigment { Both } }
#declare Turn = <-20, 40, 10>;

object { Brick scale <-1, 1, 1> rotate Turn translate <-1.4, 0.7, 0> }
object { Brick rotate Turn scale <-1, 1, 1> translate <0, 0.7, 0> }
object { Brick transform { scale <-1, 1, 1> rotate Turn } translate <1.4, 0.7, 0> }
object { Brick scale <1, -1.2, -1> translate 0.1 rotate Turn scale <-1, 1, 1> translate <-1.4, -0.7, 0> }
union { object { Brick scale <1, 1, -1> } scale <-1, 1, 1> rotate Turn translate -0.7 * y }
object { Brick scale -1 matrix <0, 1, 0, 1, 0, 0.3, 0, 0, 1, 1.4, -0.7, 0> }
