// Combinations within combinations, Depth of them (100): each cuts a sphere out of what is there and adds another.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Depth) #declare Depth = 100; #end
camera { location <0, 1.2, -2.4> look_at 0 }
light_source { <-2, 4, -3> rgb 1 }
#macro At(I) <sin(0.5 * I) * I / Depth, 0, cos(0.5 * I) * I / Depth> #end
#macro Nested(Level)
  #if (Level = 0)
    sphere { 0, 0.1 }
  #else
    merge {
      difference { Nested(Level - 1) sphere { At(Level) + 0.06 * y, 0.07 } }
      sphere { At(Level), 0.06 }
    }
  #end
#end
object { Nested(Depth / 2) pigment { rgb <1, 0.7, 0.3> } }
