// transmission.inc without transmission.
#version 3.7;
#declare With = 0;
#include "transmission.inc"
