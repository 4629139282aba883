// Strings: chapter 10 §1.3, §8.4, check case 5.
#version 3.7; global_settings { assumed_gamma 1 }
#fopen W "out.txt" write
#macro S(T) #write(W, "[", T, "]\n") #end
S(str(3.14159,0,-1)) S(str(3.14159,10,3)) S(str(3.14159,-10,3)) S(str(2.5,0,0)) S(str(3.5,0,0)) S(str(-0.0,0,1)) S(str(0*-1,0,1)) S(str(1e300,0,2)) S(str(1e300,300,2))
S(str(5,2.9,1.9)) S(str(12345,3,0)) S(str(-5,-8,2)) S(str(1/0,0,2)) S(str(1,250,0)) S(str(pi,0,30)) S(str(pi,0,240)) S(str(pi,0,260)) S(str(1,260,3))
S(vstr(3,<1,2,3>,", ",0,1)) S(vstr(3,1,",",0,1)) S(vstr(2,<1,2,3>,"",0,0)) S(vstr(5,<1,2,3>,";",5,1)) S(vstr(1,<1,2,3>,";",0,1)) S(vstr(9,<1,2,3,4,5>,";",0,1)) S(vstr(5,t,"|",-4,0))
S(concat("a")) S(concat("a","b","c")) S(concat("a",concat("b",str(1,0,0)))) S(chr(65)) S(concat(chr(65),chr(32),chr(66))) S(substr("abcdef",2,3)) S(substr("abc",1,3)) S(substr("abc",1,0))
S(strupr("abCdef1")) S(strlwr("ABcDE1")) S(datetime(0)) S(datetime(1.5,"%Y/%m/%d %H-%M-%S")) S(datetime(7300.123456)) S(datetime(0.9999999))
S("tab\tquote\"back\\slash'\'\a\b\f\v\r") S("\u0041\u0042") S("%d %s")
S(str(asc("A"),0,0)) S(str(asc(""),0,0)) S(str(strlen("hello"),0,0)) S(str(strlen(""),0,0)) S(str(strcmp("abc","ab"),0,0)) S(str(strcmp("","a"),0,0)) S(str(strcmp("abc","abd"),0,0))
S(str(strcmp("abc","abc"),0,0)) S(str(val("1.5abc"),0,4)) S(str(val("abc"),0,4)) S(str(val("0x1f"),0,4)) S(str(val(" -2e3"),0,4)) S(str(strlen(concat("ab","cd")),0,0)) S(str(strlen("a\\b"),0,0))
S(input_file_name) S(str(file_exists("text.pov"),0,0)) S(str(file_exists("nothing.here"),0,0))
S("a
b")
#declare T = "x"; #declare T = concat(T, T); S(T)
#write(W,1,",",1/3,",",1e10,",",123456789,",",1e-7,"\n") #write(W,100000,1e6,-0.0,1e15,"\n") #write(W,<1,2,3>,"e\n") #write(W,<1,2>,<1,2,3,4>,<1,2,3,4,5>,"\n")
#write(W,1,2,3,"\n") #write(W,1 2 3,"\n") #write(W,"a","b" "c\n") #write(W,1/0,"\n")
#fclose W
#fopen W "out.txt" append
#write(W,uint8 65, 66 300 -5, sint16be 258, uint16le 258, sint32be -2)
#write(W,uint8 65 66 67.5 -1 256,sint8 -129 127.5 -128,"|") #write(W,uint16be 70000 65535 1,uint16le <1,2,3>,"|") #write(W,sint16be -40000 40000,sint16le -2,"|") #write(W,sint32be 3e9 -3e9 1.5,sint32le 1,"\n")
#fclose W
