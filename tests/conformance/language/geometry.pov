// Questions to objects: chapter 10 §8.1, §8.3, check case 14.
#version 3.7; global_settings { assumed_gamma 1 }
#fopen W "out.txt" write
#macro F(V) #write(W, str(V, 0, 12), "\n") #end
#macro V3(V) #write(W, vstr(3, V, ",", 0, 6), "\n") #end
#declare O = sphere { 0,1 translate 2*x } #declare N = <0,0,0>; V3(trace(O,<2,0,-5>,z*3,N)) V3(N+5) V3(trace(O,<9,0,-5>,z,N)) V3(N+5) V3(trace(O,<2,.5,-5>,z)) F(inside(O,<2,0,0>)) F(inside(O,<0,0,0>))
#declare B = box { <-1,-2,-3>,<1,2,3> rotate 30*y } V3(trace(B,<0,0,-9>,<0,0,1>,N)) V3(N+5) V3(min_extent(B)) V3(max_extent(B)) #declare S = sphere { 0,0.1 } F(min_extent(S).x)
#declare P = plane { y,1 } V3(min_extent(P)) V3(max_extent(P)) F(inside(P,0)) F(inside(P,2*y)) #declare D = difference { sphere { 0,1 } box { -2,<0,2,2> } } V3(min_extent(D)) V3(max_extent(D)) F(inside(D,<.5,0,0>)) F(inside(D,<-.5,0,0>))
#declare U = union { sphere { x,1 } sphere { -x,1 } } V3(min_extent(U)) V3(max_extent(U)) #declare T = torus { 1,.25 } V3(trace(T,<1,5,0>,-y,N)) V3(N+5) V3(min_extent(T)) F(inside(T,x)) F(inside(T,0))
#declare C = cylinder { 0,2*y,1 } V3(trace(C,<.5,5,0>,-y,N)) V3(N+5) V3(trace(C,<5,1,0>,-x,N)) V3(N+5) #declare I = sphere { 0,1 inverse } F(inside(I,0)) V3(trace(I,-5*z,z,N)) V3(N+5)
#declare Cl = sphere { 0,1 clipped_by { plane { y,0 } } } V3(trace(Cl,<0,5,0>,-y,N)) V3(N+5) #declare M = mesh { triangle { 0,x,y } } V3(trace(M,<.2,.2,-5>,z,N)) V3(N+5) V3(max_extent(M))
#fclose W
