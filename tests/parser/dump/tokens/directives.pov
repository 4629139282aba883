#version 3.7;
#declare Ring = torus { 1, 0.25 };
#local A = array[2] { 1, 2 };
#undef A
#include "colors.inc"
#macro Put(Thing, Where) object { Thing translate Where } #end
#if (defined(Ring) & !0) Put(Ring, x) #elseif (A[0] >= 1) #else #end
#ifdef (Ring) #ifndef (B) #end #end
#for (I, 0, 3, 1) #end
#while (I < 3 | I = 3) #break #end
#switch (I) #case (1) #range (2, 3) #else #end
#default { finish { ambient 0 } }
#debug "text\n"
#  warning concat("a", str(1, 0, 0))
#error "stop"
#fopen F "file" read
#read (F, X)
#write (F, X, "\n")
#fclose F
#unknown
