// highlights.inc with highlights.
#version 3.7;
#declare With = 1;
#include "highlights.inc"
