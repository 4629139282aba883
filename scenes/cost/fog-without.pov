// base.inc without the feature "fog" of its partner.
#version 3.7;
#include "base.inc"
