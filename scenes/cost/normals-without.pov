// normals.inc without normals.
#version 3.7;
#declare With = 0;
#include "normals.inc"
