// What leaves and combinations share about boxes, clips and bounds. Source: specification chapter 20 §7.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/csg/leaf_solid.hpp"

namespace lute {

// Tests many boxes against one ray.
class BoxTest {
 public:
  explicit BoxTest(const Ray& ray) : origin_(ray.origin), inverse_(1.0 / ray.direction) {}

  // True if the ray meets the closed box at a depth in `range`. Depths are widened by a few units in the last place, so that a
  // hit on the box's own surface is never lost.
  bool meets(Interval range, const Aabb& box) const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr double kWider = 4 * std::numeric_limits<double>::epsilon();
    double near = -kInfinity, far = kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
      // For a ray along the box's side zero times infinity is not a number; such a depth limits nothing.
      const bool backward = std::signbit(inverse_[axis]);
      near = std::max(near, ((backward ? box.hi : box.lo)[axis] - origin_[axis]) * inverse_[axis]);
      far = std::min(far, ((backward ? box.lo : box.hi)[axis] - origin_[axis]) * inverse_[axis]);
    }
    near *= near > 0 ? 1 - kWider : 1 + kWider;
    far *= far > 0 ? 1 + kWider : 1 - kWider;
    return std::max(range.lo, near) <= std::min(range.hi, far);
  }

 private:
  dvec3 origin_, inverse_;
};

inline bool meets_box(const Ray& ray, Interval range, const Aabb& box) { return BoxTest(ray).meets(range, box); }

// True if a ray is tested against the solid as fast as against its box.
bool is_cheap(const Solid& solid);

bool inside_all(const SharedSolids& solids, const dvec3& point);

// True if the ray meets or starts inside every bound.
bool meets_all(const SharedSolids& bounds, const Ray& ray);

// The part of `range` outside of which no point of the ray is inside all of them; empty if none is.
Interval range_inside_all(const SharedSolids& solids, const Ray& ray, Interval range);

// Around the points of `region` that are inside all of them.
Aabb inside_all_within(const SharedSolids& solids, Aabb region);

// Lets the boxes of the bounds replace `box` where they are smaller. True if they did.
bool limit_box(Aabb& box, const SharedSolids& bounds);

// Where the inside of a clip is open on one side, as below a height field: the box of all clips, if it is smaller than `own`, that of
// the unclipped object. Rays that miss it miss the object, whatever lies inside the clips (§7.3.2).
std::optional<Aabb> closing_box(const SharedSolids& clips, const Aabb& own);

}  // namespace lute
