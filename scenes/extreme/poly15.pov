// A polynomial of order 15 in z alone, the product of (z - i/8), i = 1...15: fifteen clustered sheets, seen from slant rays.
// The first sheet, at z = 1/8, hides the others.
#version 3.7;
global_settings { assumed_gamma 1 }
// Coefficients of the product, c[k] of z^k.
#declare C = array[16];
#declare C[0] = 1;
#for (K, 1, 15) #declare C[K] = 0; #end
#for (I, 1, 15)
  #for (K, 15, 1, -1) #declare C[K] = C[K - 1] - C[K]*I/8; #end
  #declare C[0] = -C[0]*I/8;
#end
camera { location <0, 0, -2> direction z right 4/3*x up y }
// Order of the terms: by falling powers of x, then y, then z; those of z alone come last.
poly { 15, <
  #for (X, 15, 0, -1) #for (Y, 15 - X, 0, -1) #for (Z, 15 - X - Y, 0, -1)
    #if (X + Y + Z < 15 | X + Y + Z = 15)
      #if (X + Y = 0) C[Z] #else 0 #end #if (X + Y + Z > 0) , #end
    #end
  #end #end #end >
  pigment { function { mod(floor(8*x) + floor(8*y) + 100, 2) } color_map { [0.5 rgb <0, 0.5, 0>] [0.5 rgb <1, 1, 0>] } }
  finish { ambient 1 diffuse 0 }
}
background { rgb <0, 0, 1> }
