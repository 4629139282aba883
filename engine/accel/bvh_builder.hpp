// Builds the nodes of a Bvh; see bvh.hpp for the method.
#pragma once

#include <vector>

#include "engine/accel/bvh.hpp"

namespace lute {

// Orders `items` leaf by leaf and returns the nodes, the root first.
std::vector<Bvh::Node> build_bvh_nodes(std::vector<Bvh::Item>& items, BvhLeaves leaves);

}  // namespace lute
