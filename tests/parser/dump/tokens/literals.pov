// Numbers
0 7 007 1.5 .5 5. 1e3 1.5E-3 2e+4 .25e2 123456789012345678901234567890 1e400 3x -4
// Strings
"" "plain" "a \"quote\", a \\ and a\ttab" "\u00e9 and \x" "é" "two
lines"
// Names, words and old spellings
sphere spheres Sphere _name n4me colour colour_map color x y z t u v pi clock
// Vectors and operators
<1, -2.5, x> {a} (b) [c] a.x a=b a!=b a<b a<=b a>b a>=b a+b-c*d/e a&b|c!d ?:;, ^ ~ % $ @ `
