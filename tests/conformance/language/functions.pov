// User functions: chapter 10 §11, check cases 3, 13.
#version 3.7; global_settings { assumed_gamma 1 }
#fopen W "out.txt" write
#macro F(V) #write(W, str(V, 0, 18), "\n") #end
#macro Vec(N, V) #write(W, vstr(N, V, ",", 0, 9), "\n") #end
#declare f = function(x) { x/3 } F(f(5)) #declare f1 = function(a) { x+a } F(f1(5)) #declare f2 = function(n) { sum(i,1,n,i*i) } F(f2(4)) F(f2(0)) #declare f3 = function(n) { prod(i,1,n,i) } F(f3(5)) F(f3(0))
#declare f4 = function { x+y*2 } F(f4(1,2,0)) #declare f5 = function { transform { translate <1,2,3> scale 2 } } Vec(3,f5(1,1,1)) F(f5(1,1,1).y)
#declare f6 = function { pattern { checker } } F(f6(.5,.5,.5)) F(f6(1.5,.5,.5)) #declare f7 = function(x) { ln(x) } F(f7(2)) F(f7(0))
#declare f8 = function { pigment { rgb <.1,.2,.3> } } Vec(5,f8(0,0,0)) F(f8(0,0,0).gray) #declare f9 = function { spline { 0,<0,0,0> 1,<1,2,3> } } Vec(3,f9(.5))
#declare g = f; F(g(1)) #declare E1 = function(x) { x=1 } F(E1(1+1e-12)) F(E1(1)) #declare E2 = function { 1|0&0 } F(E2(0,0,0)) #declare E3 = function(x,y) { x<y } F(E3(1,2)) F(E3(2,1))
#declare D1 = function(x) { pow(x,2)+pow(x,3)*pow(x,4)-pow(x,5)+pow(x,6)+pow(x,7)+pow(x,8) } F(D1(1.1)) F(D1(-.7)) #declare D2 = function(x) { pow(x,.5) } F(D2(2)) #declare D0 = function(x) { pow(x,0) } F(D0(2))
#declare C1 = function(x) { x+0.1+0.2 } F(C1(.3)) #declare C2 = function(x) { x*3/7 } F(C2(.3)) #declare C3 = function(x) { 1-x-2 } F(C3(.3)) #declare C4 = function(x) { x<2=1 } F(C4(1)) #declare C5 = function(x) { g(1)/2*3 } F(C5(1)) #declare C6 = function(x) { g(x)/2*3 } F(C6(1))
#declare S1 = function(x) { select(x,10,20,30) } F(S1(-1)) F(S1(0)) F(S1(1)) #declare S2 = function(x) { select(x,10,20) } F(S2(-1)) F(S2(0)) F(S2(1))
#declare M1 = function(x,y) { mod(x,y)+div(x,y)+int(x)+floor(y)+ceil(x) } F(M1(7.5,2.25)) F(M1(-7.5,2.25)) #declare M2 = function(x,y) { max(x,y,1)-min(x,y,0) } F(M2(3,-2)) #declare M3 = function(x,y) { atan2(x,y)+atan2(0,0) } F(M3(1,2))
#declare T0 = function(x) { degrees(x) } F(T0(.4)) #declare T1 = function(x) { sin(x)+cos(x)+tan(x)+asin(x)+acos(x)+atan(x)+sinh(x)+cosh(x)+tanh(x)+asinh(x)+acosh(1+x)+atanh(x)+abs(-x)+radians(x)+degrees(x)+sqrt(x)+exp(x)+log(x) } F(T1(.4))
#declare K = 3; #declare Fr = function(x) { x*K } #declare K = 5; F(Fr(2)) #declare u1 = function(u,v) { u-v } F(u1(5,3)) #declare u2 = function(a,b,c) { a*b+c } F(u2(2,3,4)) F(u2(1+1,3*1,4)) F(u2(2 3 4))
#declare N1 = function(x) { -x } F(N1(2)) #declare N2 = function(x) { 2*-x } F(N2(2)) #declare N3 = function(x) { +x-(-x) } F(N3(2)) #declare N4 = function(x) { -(x+1)*2 } F(N4(2)) #declare P1 = function(x) { pi*x+clock } F(P1(1))
#declare I1 = function(x) { 1/x } F(I1(4)) F(I1(0)) #declare I2 = function { internal(61) } F(I2(1,2,3,2)) #declare H = function(x,y,z) { f4(x,y,z)+f5(x,y,z).x-f8(x,y,z).red } F(H(1,2,3))
#declare Rc = function(n) { sum(i,1,n,sum(j,1,i,i*j)) } F(Rc(4)) #declare Bx = function(x) { x>0 & x<1 | x=5 } F(Bx(.5)) F(Bx(2)) F(Bx(5))
#macro Body() y*2 #end #declare Mb = function { x + Body() } F(Mb(1,2,3)) #declare AA = array[2]{3,4} #declare Fa = function(x) { x*AA[1] } F(Fa(2)) #declare Fs = array[2] #declare Fs[0] = function(x) { x+1 } F(Fs[0](2))
// Parameters that share a slot: of x and u, and of y and v, the last counts; of equal names the first, but of equal coordinates the last.
#declare Pa = function(u,x) { x*10+u } F(Pa(1,2)) #declare Pb = function(x,y,u) { x+y+u } F(Pb(1,2,3)) #declare Pc = function(x,x) { x } F(Pc(3,4)) #declare Pd = function(a,b,a) { a } F(Pd(1,2,3))
#fclose W
