// The pictures of the scenes in scenes/extreme, worked out by hand.
#pragma once

#include "tests/extreme/extreme_case.hpp"

namespace lute::extreme {

ClosedForm planet();
ClosedForm sphere_rim();
ClosedForm grazed_floor();
ClosedForm torus_along_its_axis(double minor);
ClosedForm torus_from_a_slant(double minor);
ClosedForm everywhere();  // the object fills the picture
ClosedForm nowhere();     // only the background
ClosedForm box_edge();
ClosedForm first_sheet();
ClosedForm icosahedron();
ClosedForm turned_box();
ClosedForm clear_box_on_floor();
ClosedForm shells();
ClosedForm glass_shells();
ClosedForm slab_before_stripes(double ior, double slant);
ClosedForm unit_disc(double undecided);  // nothing is said nearer than that to the rim
ClosedForm double_cone(bool from_above);
ClosedForm bent_tube();

}  // namespace lute::extreme
