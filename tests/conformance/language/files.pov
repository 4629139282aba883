// User files: chapter 10 §6.5, check case 18. Data is written first, then read.
#version 3.7; global_settings { assumed_gamma 1 }
#fopen D "blank.txt" write #write(D, "7 8") #fclose D
#fopen D "comma.txt" write #write(D, "7,8") #fclose D
#fopen D "mixed.txt" write #write(D, "1.5, <1,2>, <1,-2,3e1>, <1,2,3,4>, <.1,.2,.3,.4,.5>, \"text\", -4 // comment\n, /* more */ 5,\n6,") #fclose D
#fopen D "some.txt" write #write(D, "1,2,3,4,5,") #fclose D
#fopen D "bare.inc" write #write(D, "#write(W, \"inc\\n\")\n#local L = 1; #declare G = 2;") #fclose D
#fopen D "bare" write #write(D, "#write(W, \"bare\\n\")") #fclose D
#fopen D "odd.txt.inc" write #write(D, "#write(W, \"odd\\n\") #if (1)") #fclose D
#fopen D "odd.txt" write #write(D, "#write(W, \"wrong\\n\")") #fclose D
#fopen W "out.txt" write
#macro F(V) #write(W, str(V, 0, 3), "\n") #end
#fopen R "blank.txt" read #while (defined(R)) #read (R, Z) F(Z) #end
#fopen R "comma.txt" read #while (defined(R)) #read (R, Z) F(Z) #end
#fopen R "mixed.txt" read #read (R, A, B, C, D4, E, T, M) F(A) #write(W, vstr(2,B,",",0,2), vstr(3,C,",",0,2), vstr(4,D4,",",0,2), vstr(5,E,",",0,2), T, "\n") F(M)
#read (R, A) F(A) F(defined(R)) #fclose R
#fopen R "some.txt" read #read (R, A, H, I) F(A) F(H) F(I) #read (R, A, H) F(A) F(H) F(defined(R)) #fclose R
#declare Arr = array[3]; #fopen R "comma.txt" read #declare Arr[0] = 0; #declare Arr[1] = 0; #read (R, Arr[0], Arr[1]) F(Arr[0]) F(Arr[1])
#include "bare" F(G) #ifdef (L) F(1) #else F(0) #end
#include "odd.txt" F(3) #end
#fclose Nothing
#fclose W
#fopen W "out.txt" append #write(W, "more\n") #write(W, 1, <1,2,3>, "x", 2, "\n") #fclose W
