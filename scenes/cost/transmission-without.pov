// base.inc without the feature "transmission" of its partner.
#version 3.7;
#include "base.inc"
