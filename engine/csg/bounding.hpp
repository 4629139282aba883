// What leaves and combinations share about boxes, clips and bounds. Source: specification chapter 20 §7.
#pragma once

#include "engine/csg/leaf_solid.hpp"

namespace lute {

// True if the ray meets the closed box at a depth in `range`.
bool meets_box(const Ray& ray, Interval range, const Aabb& box);

bool inside_all(const SharedSolids& solids, const dvec3& point);

// True if the ray meets or starts inside every bound.
bool meets_all(const SharedSolids& bounds, const Ray& ray);

// Limits `box` by clips, then lets the bounds' boxes replace it where they are smaller. True if they did.
bool limit_box(Aabb& box, const SharedSolids& clips, const SharedSolids& bounds);

}  // namespace lute
