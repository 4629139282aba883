// Tilings 25 to 27: Penrose's, by recursive division of the tile around the origin (specification chapter 50 §7.1).
#pragma once

#include "engine/math/vec.hpp"

namespace lute {

double penrose_pentagons(double x, double z);       // 25
double penrose_kites_and_darts(double x, double z); // 26
double penrose_rhombs(double x, double z);          // 27

}  // namespace lute
