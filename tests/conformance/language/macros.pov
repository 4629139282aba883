// Names, scopes and macros: chapter 10 §3, §5, check case 9.
#version 3.7; global_settings { assumed_gamma 1 }
#fopen W "out.txt" write
#macro F(V) #write(W, str(V, 0, 6), "\n") #end
#macro V3(V) #write(W, vstr(3, V, ",", 0, 6), "\n") #end
#macro pm(A) #declare A = A + 1; #end #declare Q = 5; pm(Q) F(Q) pm(Q+0) F(Q) pm((Q)) F(Q) pm(+Q) F(Q)
#macro loc(A) #local A = 99; #end #declare Q = 1; loc(Q) F(Q)
#macro part() 2+3 #end #declare R = part()*2; F(R) F((part())*2)
#macro MM(A,B) A-B #end #declare R = MM(1,-2); F(R) #declare R = MM(1 -2,3); F(R)
#macro sw(A,B) #local T = A; #declare A = B; #declare B = T; #end #declare A1 = 1; #declare B1 = <1,2,3>; sw(A1,B1) V3(A1) F(B1)
#macro In() F(L) #declare L = 2; #end #macro Out() #local L = 1; In() F(L) #end Out() #ifdef (L) F(9) #else F(8) #end
#macro E(n) #if (n) #break #end F(n) #end E(1) E(0)
#macro el(A) #declare A = 7; #end #declare Q = array[2]{1,2} el(Q[1]) F(Q[1])
#macro ar(A) #declare A[0] = 3; #end ar(Q) F(Q[0])
#macro Rec(n) #if (n > 0) F(n) Rec(n-1) #end #end Rec(3)
#macro S(V) #local R = V*V; R #end #declare A = S(2) + S(3); F(A)
#macro M5() 5 #end #declare A = M5(); F(A) #macro M6() 6; #end #declare A = M6() F(A)
#macro Inner() #macro Made() F(42) #end #end Inner() Made()
#macro Redefine() F(1) #end Redefine() #macro Redefine() F(2) #end Redefine()
#macro str1(T) #write(W, T, "\n") #end str1("abc") str1(concat("a","b")) #declare TT = "def"; str1(TT)
#macro col(C) V3(C) #end col(rgb <1,2,3>) col(color rgb 0.5) #declare CC = rgb <.25,.5,.75>; col(CC) col(CC*2)
#macro opt(A,B,C) F(A+B*10+C*100) #end opt(1 2 3) opt(1,2,3) opt((1)(2)(3))
#macro vecs(V) V3(V) #end vecs(<1,2,3>) vecs(x) vecs(2*x+y) #declare VV = <4,5,6>; vecs(VV) vecs(VV*2) vecs(VV.y)
#local L1 = 4; F(L1) #macro Sc() #local L1 = 5; F(L1) #end Sc() F(L1)
#macro Glob() #declare G1 = 5; #local G2 = 6; #end Glob() #ifdef (G1) F(1) #end #ifdef (G2) F(2) #else F(3) #end
#declare A = 1; #declare A = <1,2,3>; #declare A = "text"; str1(A)
#declare deprecated Old = 3; F(Old) #declare deprecated once "use New" Old2 = 3; F(Old2) F(Old2)
#declare X1 = A1; #declare X1 = X1 + 1; V3(X1) V3(A1)
#declare Ar = array[2]{1,2} #declare Br = Ar; #declare Br[0] = 9; F(Ar[0]) F(Br[0])
#macro Two(A, A) F(A) #end Two(1, 2)
#fclose W
