// base.inc with clear solids.
#version 3.7;
#declare Paint = pigment { rgbf <0.9, 0.8, 0.7, 0.8> }
#include "base.inc"
