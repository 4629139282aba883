// highlights.inc without highlights.
#version 3.7;
#declare With = 0;
#include "highlights.inc"
