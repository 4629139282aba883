// base.inc with bumps.
#version 3.7;
#declare Bumps = 1;
#include "base.inc"
