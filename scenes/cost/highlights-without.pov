// base.inc without the feature "highlights" of its partner.
#version 3.7;
#include "base.inc"
