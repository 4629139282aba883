// The traversal of a Bvh, compiled for each instruction set: include it inside a file that includes
// <hwy/foreach_target.h>.
//
// Why no hit is lost (Ize, "Robust BVH ray traversal", 2013): the boxes are rounded outward; the ray's origin is
// rounded to single precision upward for one plane of a slab and downward for the other, whichever makes the slab
// wider, with a little more for directions that are (nearly) parallel to the slab; the remaining errors are three
// roundings relative to the depth, and the exit depth is widened by more than those. Depths of zero times infinity do
// not occur: reciprocals are kept finite and not zero.
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/accel/bvh.hpp"

#if defined(LUTE_ACCEL_BVH_TRAVERSAL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LUTE_ACCEL_BVH_TRAVERSAL_INL
#undef LUTE_ACCEL_BVH_TRAVERSAL_INL
#else
#define LUTE_ACCEL_BVH_TRAVERSAL_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace lute::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// A single-precision bound just above a depth; the margin covers the rounding of the entry depths that it is compared
// with.
HWY_INLINE float depth_above(double t) {
  constexpr double kMax = std::numeric_limits<float>::max();
  return t < 1e30 ? static_cast<float>(t * (1 + 1e-6) + 1e-37) : static_cast<float>(t > kMax ? kMax : t);
}
HWY_INLINE float depth_below(double t) { return t > 0 ? static_cast<float>(std::min(t * (1 - 1e-6), 1e37)) : 0.0f; }

// What depends on the signs of a ray's direction only.
struct SlabSides {
  double sign[4];  // -1: backward along the axis
  std::size_t near_plane[3], far_plane[3];  // offsets into a node, in floats
};

// For each combination of signs: bit a is set for backward along axis a.
inline constexpr std::array<SlabSides, 8> kSlabSides = [] {
  std::array<SlabSides, 8> all{};
  for (std::size_t bits = 0; bits < 8; ++bits) {
    for (std::size_t a = 0; a < 3; ++a) {
      const bool backward = (bits >> a & 1) != 0;
      const std::size_t lower = a * Bvh::kWidth, upper = (3 + a) * Bvh::kWidth;
      all[bits].sign[a] = backward ? -1 : 1;
      all[bits].near_plane[a] = backward ? upper : lower;
      all[bits].far_plane[a] = backward ? lower : upper;
    }
  }
  return all;
}();

// The ray as the slab test wants it. It is made four lanes at a time, of which three count: axes are in lanes 0 to 2 of the origin and in
// lanes 1 to 3 of the direction, so that both can be loaded from the six numbers of the ray.
struct SlabRay {
  alignas(16) float near_origin[4], far_origin[4];
  alignas(16) float near_reciprocal[4], far_reciprocal[4];  // [1 + axis]
  const SlabSides* sides;
  bool defined;  // no number of the ray is infinite or NaN

  SlabRay(const Ray& ray, const std::array<double, 4>& tree_origin) {
    static_assert(sizeof(Ray) == 6 * sizeof(double));
    const hn::CappedTag<double, 4> d;
    const hn::Rebind<float, decltype(d)> single;
    constexpr double kLargest = 1e37;
    const auto largest = hn::Set(d, kLargest), zero = hn::Zero(d);
    const double* const numbers = &ray.origin.x;
    const auto sign_bit = [&](int i) { return static_cast<std::size_t>(std::bit_cast<std::uint64_t>(numbers[i]) >> 63); };
    sides = &kSlabSides[sign_bit(3) | sign_bit(4) << 1 | sign_bit(5) << 2];
    auto nothing = zero;  // stays zero
    for (std::size_t c = 0; c < 4; c += hn::Lanes(d)) {
      const auto origin = hn::LoadU(d, numbers + c), direction = hn::LoadU(d, numbers + 2 + c);
      nothing = hn::Add(nothing, hn::Add(hn::Mul(origin, zero), hn::Mul(direction, zero)));
      const auto from_tree = hn::Sub(origin, hn::LoadU(d, tree_origin.data() + c));
      const auto o = hn::Min(hn::Max(from_tree, hn::Neg(largest)), largest);
      const auto margin = hn::Max(hn::Mul(hn::Abs(o), hn::Set(d, 0x1p-23)), hn::Set(d, 1e-26));
      const auto above = hn::Add(o, margin), below = hn::Sub(o, margin);
      const auto backward = hn::Lt(hn::LoadU(d, sides->sign + c), zero);
      hn::Store(hn::DemoteTo(single, hn::IfThenElse(backward, below, above)), single, near_origin + c);
      hn::Store(hn::DemoteTo(single, hn::IfThenElse(backward, above, below)), single, far_origin + c);
      const auto steep = hn::Gt(hn::Abs(direction), hn::Set(d, 1 / kLargest));
      const auto r = hn::IfThenElse(steep, hn::Div(hn::Set(d, 1.0), direction), hn::CopySign(largest, direction));
      hn::Store(hn::DemoteTo(single, r), single, near_reciprocal + c);
      hn::Store(hn::DemoteTo(single, hn::Mul(r, hn::Set(d, 1 + 1e-6))), single, far_reciprocal + c);
    }
    defined = hn::AllTrue(d, hn::Eq(nothing, zero));
  }
};

// Tests the eight boxes of a node; returns a bit for each one that the ray meets in [lo, hi], and its entry depth.
HWY_INLINE std::uint32_t meets(const Bvh::Node& node, const SlabRay& ray, float lo, float hi,
                               float* HWY_RESTRICT entries) {
  const hn::CappedTag<float, Bvh::kWidth> d;
  const float* planes = &node.lo[0][0];  // lo, then hi
  std::uint32_t mask = 0;
  for (std::size_t c = 0; c < Bvh::kWidth; c += hn::Lanes(d)) {
    const auto entry_of = [&](std::size_t a) HWY_ATTR {
      return hn::Mul(hn::Sub(hn::Load(d, planes + ray.sides->near_plane[a] + c), hn::Set(d, ray.near_origin[a])),
                     hn::Set(d, ray.near_reciprocal[1 + a]));
    };
    const auto exit_of = [&](std::size_t a) HWY_ATTR {
      return hn::Mul(hn::Sub(hn::Load(d, planes + ray.sides->far_plane[a] + c), hn::Set(d, ray.far_origin[a])),
                     hn::Set(d, ray.far_reciprocal[1 + a]));
    };
    const auto entry = hn::Max(hn::Max(entry_of(0), entry_of(1)), hn::Max(entry_of(2), hn::Set(d, lo)));
    const auto exit = hn::Min(hn::Min(exit_of(0), exit_of(1)), hn::Min(exit_of(2), hn::Set(d, hi)));
    hn::Store(entry, d, entries + c);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Le(entry, exit), bits);
    mask |= static_cast<std::uint32_t>(bits[0]) << c;
  }
  return mask;
}

// Calls `leaf(first, count, far)` for leaves near to far until it returns true; it may lower `far`, by depth_above().
// With `ordered` false children come in no particular order: for any-hit queries.
template <bool ordered, class Leaf>
HWY_INLINE void traverse(const Bvh& bvh, const Ray& ray, float near, float far, std::uint64_t& box_tests, Leaf&& leaf) {
  // An undefined ray meets nothing. (It would meet even the empty children: comparisons with NaN are not what they
  // seem.)
  if (bvh.empty()) return;
  const SlabRay slab(ray, bvh.origin());
  if (!slab.defined) return;
  const Bvh::Node* const nodes = bvh.nodes().data();
  struct Pending {
    float distance;
    std::int32_t child;
    std::uint32_t count;
  };
  Pending stack[Bvh::kMaxDepth * (Bvh::kWidth - 1) + 1];
  Pending* top = stack;
  std::uint64_t visited = 0;
  Pending next{near, 0, 0};
  for (;;) {
    if (next.child < 0) {
      if (leaf(static_cast<std::uint32_t>(~next.child), next.count, far)) break;
    } else {
      const Bvh::Node& node = nodes[next.child];
      ++visited;
      alignas(64) float entries[Bvh::kWidth];
      std::uint32_t mask = meets(node, slab, near, far, entries);
      if (std::has_single_bit(mask)) {  // most often: no need for the stack
        const auto c = static_cast<std::size_t>(std::countr_zero(mask));
        next = {entries[c], node.child[c], node.count[c]};
        continue;
      }
      Pending* const base = top;
      while (mask != 0) {
        const auto c = static_cast<std::size_t>(std::countr_zero(mask));
        mask &= mask - 1;
        Pending* at = top++;
        // Farther ones below nearer ones: the nearest is popped first.
        if constexpr (ordered)
          for (; at > base && at[-1].distance < entries[c]; --at) *at = at[-1];
        *at = {entries[c], node.child[c], node.count[c]};
      }
    }
    do {
      if (top == stack) {
        box_tests += visited;
        return;
      }
      next = *--top;
    } while (!(next.distance <= far));
  }
  box_tests += visited;
}

}  // namespace lute::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
