// base.inc in fog.
#version 3.7;
#include "base.inc"
fog { distance 12 rgb 0.7 }
