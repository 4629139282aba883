// base.inc without the feature "normals" of its partner.
#version 3.7;
#include "base.inc"
