// The random points that crackle and facets measure distances to: one in each unit cube (specification chapter 50 §6.4).
#pragma once

#include "engine/math/vec.hpp"

namespace lute {

// The three smallest sums of |component of the distance|^metric among the 81 cubes around a point, ascending, and the nearest point.
struct FeaturePoints {
  double distance[3];
  dvec3 nearest;
};
// Only the first `wanted` (1 to 3) of the distances are needed: the others may come out too large.
FeaturePoints crackle_points(const dvec3& p, double metric, int wanted);
// The distances alone: cheaper.
dvec3 crackle_distances(const dvec3& p, double metric, int wanted);

// The nearest point as facets measure it: with metric 1 distances keep their sign.
dvec3 facet_point(const dvec3& p, double metric);

}  // namespace lute
