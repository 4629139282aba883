// What interval arithmetic knows of a function of x, y, z in a box: its values and its partial derivatives, in an octree whose nodes are
// bounded when a ray first asks for them, and divided where their bounds have proven too wide often enough to pay for closer ones.
// Everything it says is proven, so that an answer may depend on the rays that came before in its sharpness, never in its truth. Any
// number of threads may ask at once.
// Source: octree and proofs of empty stretches: D. Kalra, A. H. Barr, Guaranteed ray intersections with implicit surfaces, 1989;
// enclosures: engine/function/enclosure.hpp.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "engine/function/function.hpp"
#include "engine/math/aabb.hpp"
#include "engine/math/interval.hpp"
#include "engine/math/ray.hpp"

namespace lute {

class SlopeTree {
  struct Node;

 public:
  SlopeTree(std::shared_ptr<const Function> function, const Aabb& box);
  ~SlopeTree();
  SlopeTree(const SlopeTree&) = delete;
  SlopeTree& operator=(const SlopeTree&) = delete;

  // A bound of the slope in any direction and everywhere in the box; infinite if there is none.
  double steepest() const;
  // False if the function has no enclosure: then nothing is known anywhere.
  bool knows_function() const;

  // The function along the part of a ray that lies in one node: between which numbers its values lie, and its derivatives by the depth,
  // which find_slope() finds when they are needed.
  struct Piece {
    double end;  // depth; the piece begins where the one before ends
    Interval value;
    const Node* node;
    Interval slope{};
    bool slope_known = false;
  };
  // The pieces between two depths within the box, ascending.
  void along(const Ray& ray, Interval depths, std::vector<Piece>& out) const;
  static void find_slope(const Ray& ray, Piece& piece);
  // Tells a node that its bounds did not do.
  static void too_wide(const Piece& piece);

 private:
  struct Walk;
  struct Octants;
  const Node& root() const;
  void bound(Node& node, const dvec3& center, const dvec3& half) const;
  const Octants& divide(const Node& node, const dvec3& center, const dvec3& quarter) const;

  std::shared_ptr<const Function> function_;
  dvec3 center_, half_;  // of the box
  mutable std::once_flag made_;
  mutable std::unique_ptr<Node> root_;  // when the first ray asks
  mutable double steepest_ = 0;         // with the root
};

}  // namespace lute
