// fog.inc without fog.
#version 3.7;
#declare With = 0;
#include "fog.inc"
