// Where in a box a function is known to be no steeper than a limit: interval arithmetic over a grid of cells, coarse ones first. An isosurface
// needs no other test of a step there than its max_gradient; elsewhere it bounds every step by itself.
// Source: specification chapter 21 §8.3; enclosures as in engine/function/enclosure.hpp.
#pragma once

#include <bitset>
#include <vector>

#include "engine/function/function.hpp"
#include "engine/math/aabb.hpp"
#include "engine/math/interval.hpp"
#include "engine/math/ray.hpp"

namespace lute {

class SlopeProof {
 public:
  // `function` of x, y, z must outlive the proof.
  SlopeProof(const Function& function, const Aabb& box, double limit);

  // False if the function has no enclosure: then nothing can be proven or doubted, neither here nor for a stretch of a ray.
  bool possible() const { return possible_; }
  bool everywhere() const { return everywhere_; }
  // The stretches of the ray between these depths where it meets cells that are not proven, ascending.
  void doubtful(const Ray& ray, Interval depths, std::vector<Interval>& out) const;

 private:
  static constexpr int kSide = 16;  // cells along each axis
  // Interval arithmetic takes the steepest direction of every term at once. Up to this factor above the limit the author's number is
  // believed if the slopes at the middle and the corners of the cell do not refute it.
  static constexpr double kBelief = 2;

  // Proves the cells [first, first + count) along each axis, or marks them; false if the function has no enclosure.
  bool prove(const Function& function, const int first[3], int count);
  double steepest(const Function& function, const Aabb& cell) const;
  bool is_gentle_at_samples(const Function& function, const Aabb& cell) const;
  Aabb cell_box(const int first[3], int count) const;

  Aabb box_;
  double limit_;
  bool possible_ = true, everywhere_ = true;
  std::bitset<kSide * kSide * kSide> unproven_;
};

}  // namespace lute
