// A slab with Side x Side holes: 10,000 children, or other numbers with Declare=Side=...
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Side) #declare Side = 100; #end
camera { location <0.3, 1.5, -1.5> look_at 0 }
light_source { <-2, 4, -3> rgb 1 }
difference {
  box { <-1, -0.1, -1>, <1, 0.1, 1> }
  #for (I, 0, Side - 1) #for (K, 0, Side - 1)
    sphere { <-1 + (2 * I + 1) / Side, 0.1, -1 + (2 * K + 1) / Side>, 0.9 / Side }
  #end #end
  pigment { rgb <1, 0.7, 0.3> }
}
