// base.inc with highlights.
#version 3.7;
#declare Look = finish { ambient 0.1 diffuse 0.8 specular 0.6 roughness 0.02 }
#include "base.inc"
