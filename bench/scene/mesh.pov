// A dense scene for `lute-compare speed bench/scene`: copies of a mesh of 7,200 smooth triangles, 12 x 9 x 3.
#include "field.inc"
#declare Shape = mesh {
  #macro Point(I, K) #local R = 0.8 + 0.15 * sin(5 * 6 * I * pi / 180) * sin(4 * 3 * K * pi / 180); R * vrotate(y, <3 * K, 6 * I, 0>) #end
  #for (I, 0, 59)
    #for (K, 0, 59)
      #local A = Point(I, K); #local B = Point(I + 1, K); #local C = Point(I, K + 1); #local D = Point(I + 1, K + 1);
      smooth_triangle { A, A, B, B, C, C }
      smooth_triangle { D, D, B, B, C, C }
    #end
  #end
}
Field(Shape, 12, 9)
