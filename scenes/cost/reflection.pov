// base.inc with mirrors.
#version 3.7;
#declare Look = finish { ambient 0.1 diffuse 0.5 reflection 0.4 }
#include "base.inc"
