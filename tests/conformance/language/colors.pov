// Colours as values: chapter 10 §9.1, check case 12.
#version 3.7; global_settings { assumed_gamma 1 }
#fopen W "out.txt" write
#macro C(V) #write(W, vstr(5, V, ",", 0, 10), "\n") #end
#macro D(K) #declare CV = K; C(CV) #end
#declare A = rgbt <.1,.2,.3,.4>; C(A) #declare A = rgbft 0.25; C(A) #declare A = rgbt 0.25; C(A) #declare A = rgbf 0.25; C(A) #declare A = color .5; C(A) #declare A = rgb 0.3; C(A) #declare A = color red 1 filter 0.5; C(A)
#declare C1 = rgb <1,.5,.25>; #declare A = color C1 green .9; C(A) C(C1+1) C(C1*2) #write(W, str(C1.gray,0,5), "\n") #declare A = rgb <1,2>; C(A) #declare A = rgb <.1,.2,.3,.4,.5>; C(A) #declare A = rgbf <1,2,3>; C(A)
#declare A = color rgb <1,0,0> transmit .5; C(A) #declare A = red .2; C(A) #declare A = rgb 1 blue 0 filter .1 transmit .2; C(A) #declare A = color <1,2,3,4,5>; C(A) #declare A = <1,2,3,4,5>; C(A) #declare A = color; C(A)
#declare A = srgb <.5,.25,.75>; C(A) #declare A = srgbt <.02,.04,1,.5>; C(A) #declare A = srgbf 0.5; C(A) #declare A = srgbft <.1,.2,.3,.4,.5>; C(A) #declare A = rgb C1*<1,2,3>; C(A) #declare A = rgb 1 + 0; C(A) #declare A = rgb <C1.red,C1.green,5>; C(A)
#declare A = color alpha .3; C(A) #declare A = rgb x; C(A) #declare A = rgb (1 ? x : y); C(A) #declare V = <1,2,3>; #declare A = color V; C(A) #declare A = rgb V; C(A) #declare A = V; #write(W, vstr(3, A, ",", 0, 3), "\n")
#declare A = C1; C(A) #declare A = C1*C1; C(A) #declare A = 2*C1; C(A) #declare A = C1-<1,1,1>; C(A)
#fclose W
