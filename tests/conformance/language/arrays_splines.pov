// Arrays and splines: chapter 10 §9.2, §10, check cases 10, 11.
#version 3.7; global_settings { assumed_gamma 1 }
#fopen W "out.txt" write
#macro F(V) #write(W, str(V, 0, 12), "\n") #end
#macro Vec(N, V) #write(W, vstr(N, V, ",", 0, 9), "\n") #end
#declare A = array[2][3]{{1,2,3},{4,5,6}} F(A[0][0]) F(A[1][2]) F(A[0.9][1.9]) F(dimensions(A)) F(dimension_size(A,1)) F(dimension_size(A,2)) F(dimension_size(A,3)) F(dimension_size(A,0))
#declare B = array[3]{1 2 3} F(B[0]+B[1]*B[2]) #declare B[1] = 7; F(B[1]) #declare C = array[2]{<1,2,3>,<4,5,6>} Vec(3,C[1]) F(C[1].y)
#declare D = array[2]{"a","b"} #write(W,D[0],D[1],"\n") #declare E = array[2] #declare E[0] = B; F(E[0][2]) #declare E[1] = A; F(E[1][1][0])
#declare G = array[1]{array[2]{5,6}} F(G[0][1]) #declare I = 0; #while (I < dimension_size(B,1)) F(B[I]) #declare I = I + 1; #end
#macro P(K) 0,<0,0,0> 1,<1,2,3> 2,<3,1,0> 4,<0,1,1> #end
#declare L = spline { P(0) } #declare Q = spline { quadratic_spline P(0) } #declare N = spline { natural_spline P(0) } #declare K = spline { cubic_spline P(0) 5,<0,0,2> }
#for (T, -1, 6, 0.27) Vec(3,L(T)) Vec(3,Q(T)) Vec(3,N(T)) Vec(3,K(T)) Vec(3,L(T,cubic_spline)) Vec(3,L(T,natural_spline)) Vec(3,K(T,linear_spline)) Vec(3,N(T,quadratic_spline)) #end
#declare S = spline { cubic_spline 0,<0,2,4> 1,<1,1,1> } Vec(3,S(0)) Vec(3,S(.3)) Vec(3,S(1))
#declare S = spline { natural_spline 0,<0,2,4> 1,<1,1,1> } Vec(3,S(.3)) #declare S = spline { quadratic_spline 0,<0,2,4> 1,<1,1,1> } Vec(3,S(.3))
#declare S = spline { 3, <1,2> } Vec(2,S(0)) Vec(2,S(3)) Vec(2,S(9))
#declare S = spline { linear_spline 0,0 1,<1,1,1> 1,<9,9,9> } F(S(1).x) #declare S = spline { linear_spline 0,0 1,1 2,2 1,9 2,9 } F(S(1).x) F(S(2).x)
#declare S = spline { 0,<5,6,7> 1,1 } Vec(3,S(1)) #declare S = spline { 2,<3,3> 0,<1,1> 1,<5,5> } Vec(2,S(.5)) Vec(2,S(1.5))
#declare S = spline { 0,<1,2,3,4,5> 1,<2,3,4,5,6> } Vec(5,S(.5)) F(S(.5).y) #declare T2 = spline { S natural_spline 2,<0,0,0,0,0> } Vec(5,T2(1.5)) Vec(5,S(1.5))
#declare S = spline { linear_spline 0,0 0,1 0,2 } F(S(0).x) F(S(1).x) #declare S = spline { linear_spline 1,1 1,2 1,3 2,0 } F(S(1).x) F(S(1.5).x) #declare S = spline { linear_spline 1,1 1,2 0,0 } F(S(.5).x) F(S(1).x)
#fclose W
