// Float and vector functions: chapter 10 §8, check cases 1, 6, 7.
#version 3.7; global_settings { assumed_gamma 1 }
#fopen W "out.txt" write
#macro F(V) #write(W, str(V, 0, 12), "\n") #end
#macro V3(V) #write(W, vstr(3, V, ",", 0, 10), "\n") #end
F(abs(-2)) F(ceil(1.2)) F(ceil(-1.2)) F(floor(1.2)) F(floor(-1.2)) F(exp(1)) F(sin(1)) F(cos(1)) F(tan(1)) F(atan(1)) F(sinh(1)) F(cosh(1)) F(tanh(1))
F(asinh(1)) F(acosh(2)) F(atanh(.5)) F(acos(.5)) F(asin(.5)) F(acos(2)) F(asin(-2)) F(atan2(1,2)) F(atan2(-1,-2)) F(atan2(0,-1)) F(sqrt(2)) F(ln(2)) F(log(2))
F(pow(2,.5)) F(pow(0,2)) F(pow(0,-1)) F(pow(-2,3)) F(mod(-7,3)) F(mod(7,-3)) F(mod(5.5,2)) F(int(-2.7)) F(int(2.7)) F(int(3e9)) F(div(-7,2)) F(div(7,2)) F(div(7,0))
F(max(1,3,2)) F(min(3,1,2)) F(max(5)) F(select(-1,10,20)) F(select(0,10,20)) F(select(1,10,20)) F(select(-1,10,20,30)) F(select(0,10,20,30)) F(select(1,10,20,30))
F(degrees(1)) F(radians(180)) F(bitwise_and(12,10)) F(bitwise_or(12,10,1)) F(bitwise_xor(12,10)) F(bitwise_and(-1,255)) F(bitwise_or(7)) F(bitwise_xor(3.9,1))
F(vlength(<1,2,3>)) F(vdot(<1,2,3>,<4,5,6>)) F(abs(1<2)) F(sin(1|0))
V3(vcross(<1,2,3>,<4,5,6>)) V3(vnormalize(<1,2,3>)) V3(vnormalize(0)) V3(vrotate(<1,2,3>,<10,20,30>)) V3(vrotate(<1,2,3>,90*y)) V3(vrotate(x,<0,0,90>))
V3(vaxis_rotate(x,y,90)) V3(vaxis_rotate(<1,2,3>,<1,1,1>,30)) V3(vturbulence(2,0.5,6,<0.3,0.7,1.1>)) V3(vturbulence(2,0.5,1,<0.3,0.7,1.1>)) V3(vturbulence(3,.7,20,<-5,.25,1e3>))
#macro R(S) #local G = seed(S); F(rand(G)) F(rand(G)) F(rand(G)) #end
R(0) R(12345) R(-1) R(7) R(1) R(2147483647) R(1.9) R(-2.9)
#declare A = seed(5); #declare B = seed(5); F(A) F(B) F(rand(A)) F(rand(A)) F(rand(B)) F(rand(A))
#fclose W
