// fog.inc with fog.
#version 3.7;
#declare With = 1;
#include "fog.inc"
