// base.inc without the feature "reflection" of its partner.
#version 3.7;
#include "base.inc"
