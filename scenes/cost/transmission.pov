// transmission.inc with transmission.
#version 3.7;
#declare With = 1;
#include "transmission.inc"
