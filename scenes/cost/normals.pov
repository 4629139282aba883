// normals.inc with normals.
#version 3.7;
#declare With = 1;
#include "normals.inc"
