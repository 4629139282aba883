// pavement: the last pattern of every number of sides and tiles, with each kind of interior, exterior and form.
// lute scenes/feature/pattern/pavements.pov -W360 -H180
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <3, 1.5, -10> look_at <3, 1.5, 0> right 6*x up 3*y }
#default { finish { ambient 0 emission 1 diffuse 0 } }

#declare Sides = array[3] { 3, 4, 6 };
#declare Last = array[3][6] { { 1, 1, 1, 3, 4, 12 }, { 1, 1, 2, 5, 12, 35 }, { 1, 1, 3, 7, 22, 0 } };
#for (Row, 0, 2)
  #for (Tiles, 1, (Sides[Row] = 6 ? 5 : 6))
    box {
      0, <0.97, 0.97, 1>
      pigment {
        pavement number_of_sides Sides[Row] number_of_tiles Tiles pattern Last[Row][Tiles-1]
        interior mod(Tiles, 3) exterior mod(Tiles+1, 3) form mod(Tiles, 3)
        color_map { [0 rgb 0] [1 rgb <0.7, 0.9, 1>] } scale 0.12 rotate -90*x
      }
      translate <Tiles - 1, 2 - Row, 0>
    }
  #end
#end
