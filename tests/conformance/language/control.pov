// Conditionals, loops, switches: chapter 10 §2, §4, check cases 8, 20.
#version 3.7; global_settings { assumed_gamma 1 }
#fopen W "out.txt" write
#macro F(V) #write(W, str(V, 0, 12), "\n") #end
#declare N = 0; #for (I,1,2,0.1) #declare N = N + 1; #end F(N) F(I)
#for (K,3,1) F(-1) #end F(K) #for (K,3,1,-1) F(K) #end F(K)
#declare N = 0; #for (I,1,3) #declare I = I + 1; #declare N = N + 1; #end F(N) F(I)
#for (I,1,5) #if (I = 3) #break #end F(I) #end F(I)
#for (I, 0, 1, 1/3) F(I) #end F(I) #for (I 1 2) F(I) #end #for (I, 1+1, 2*2, 3-2) F(I) #end
#for (I,1,2) #for (J,I,3) F(I*10+J) #end #end
#macro Sw(q) #switch (q) #case (1) F(1) #break #case (2) F(2) #range (2.5,4) F(3) #else F(4) #end F(0) #end
Sw(2) Sw(3) Sw(9) Sw(1) Sw(2.5) Sw(4) Sw(1+1e-11) Sw(4+1e-11)
#switch (7) #case (1) F(1) #end #switch (7) #range (1,9) F(2) #else F(3) #end
#declare M = 3; #while (M > 0) #declare M = M - 1; #if (M = 1) #break #end F(M) #end F(M)
#if (0) F(1) #elseif (1) F(2) #elseif (1) F(3) #else F(4) #end #if (1e-11) F(1) #else F(2) #end
#if (0) F(1) #elseif (0) F(2) #else F(4) #end
#ifdef (pi) F(1) #else F(2) #end #ifdef (image_width) F(1) #end #ifndef (Nowhere) F(1) #end #ifdef (N) F(1) #else F(2) #end
#declare A = array[2]; #declare A[0] = 1; #ifdef (A[0]) F(1) #end #ifdef (A[1]) F(1) #else F(2) #end F(defined(A[1])) F(defined(A)) F(defined(Nix))
#declare A = (1 + #if (1) 2 #else 3 #end *4); F(A) #declare A = #if (1) 5; #end F(A)
#ifndef (Undefined_name) F(1) #else x y #foo zzz "str #end" $ % #end
#if (0) /* #end */ // #end
"#end" #end F(1) /* a /* b */ c */ F(2)
#if (0) #while (1) #macro M() #end #end a #elseif (1) F(3) #else b #end
#declare B = 2; #declare A = (B + #declare B = 7; B); F(A)
# /* blank */ declare C = 5; F(C) #
declare C = 6; F(C)
#declare A = 1 + #declare Z1 = 3; Z1 * 2; F(A)
#undef A #ifdef (A) F(1) #else F(0) #end
#fclose W
