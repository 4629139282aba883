// reflection.inc without reflection.
#version 3.7;
#declare With = 0;
#include "reflection.inc"
