// reflection.inc with reflection.
#version 3.7;
#declare With = 1;
#include "reflection.inc"
