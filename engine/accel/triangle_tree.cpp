#include "engine/accel/triangle_tree.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/accel/triangle_tree.cpp"
#include <hwy/foreach_target.h>

#include "engine/accel/bvh_traversal-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace lute::HWY_NAMESPACE {
namespace {

using Block = TriangleTree::Block;

// The ray in the frame of the test: axis `k`, along which it runs most, becomes depth; shearing makes it the origin of
// `i` and `j`.
struct ShearedRay {
  std::size_t i, j, k;
  double origin[3];  // of axes i, j, k
  double shear_i, shear_j, shear_k;

  explicit ShearedRay(const Ray& ray) : k(0) {
    const dvec3& d = ray.direction;
    if (std::abs(d.y) > std::abs(d.x)) k = 1;
    if (std::abs(d.z) > std::abs(k == 0 ? d.x : d.y)) k = 2;
    i = (k + 1) % 3;
    j = (k + 2) % 3;
    const auto along = [](const dvec3& v, std::size_t axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; };
    origin[0] = along(ray.origin, i);
    origin[1] = along(ray.origin, j);
    origin[2] = along(ray.origin, k);
    shear_k = 1 / along(d, k);
    shear_i = along(d, i) * shear_k;
    shear_j = along(d, j) * shear_k;
  }
};

// What the test found for the lanes of a block whose bit is set.
struct alignas(32) Crossings {
  double t[4], u[4], v[4], w[4];  // depth and the edge functions opposite of the corners
  std::uint32_t mask = 0;
};

using D = hn::CappedTag<double, 4>;
using F = hn::Rebind<float, D>;

struct Corner {
  hn::Vec<D> x, y, z;  // sheared: x and y across the ray, z along it
};

HWY_INLINE Corner sheared(const float (&corner)[3][4], std::size_t lane, const ShearedRay& ray) {
  const D d;
  const F f;
  const auto z = hn::Sub(hn::PromoteTo(d, hn::Load(f, corner[ray.k] + lane)), hn::Set(d, ray.origin[2]));
  const auto x = hn::Sub(hn::PromoteTo(d, hn::Load(f, corner[ray.i] + lane)), hn::Set(d, ray.origin[0]));
  const auto y = hn::Sub(hn::PromoteTo(d, hn::Load(f, corner[ray.j] + lane)), hn::Set(d, ray.origin[1]));
  return {hn::Sub(x, hn::Mul(hn::Set(d, ray.shear_i), z)), hn::Sub(y, hn::Mul(hn::Set(d, ray.shear_j), z)), z};
}

HWY_INLINE hn::Vec<D> edge(const Corner& from, const Corner& to) {
  return hn::Sub(hn::Mul(from.x, to.y), hn::Mul(from.y, to.x));
}

// Finds the lanes that are hit at a depth in [lo, hi].
HWY_INLINE void cross(const Block& block, const ShearedRay& ray, double lo, double hi, Crossings& out) {
  const D d;
  out.mask = 0;
  for (std::size_t lane = 0; lane < 4; lane += hn::Lanes(d)) {
    const Corner a = sheared(block.corner[0], lane, ray);
    const Corner b = sheared(block.corner[1], lane, ray);
    const Corner c = sheared(block.corner[2], lane, ray);
    const auto u = edge(c, b);
    const auto v = edge(a, c);
    const auto w = edge(b, a);
    const auto zero = hn::Zero(d);
    const auto least = hn::Min(hn::Min(u, v), w);
    const auto greatest = hn::Max(hn::Max(u, v), w);
    const auto sum = hn::Add(hn::Add(u, v), w);
    auto hit = hn::And(hn::Or(hn::Ge(least, zero), hn::Le(greatest, zero)), hn::Ne(sum, zero));
    if (hn::AllFalse(d, hit)) continue;
    const auto depth = hn::Add(hn::Add(hn::Mul(u, a.z), hn::Mul(v, b.z)), hn::Mul(w, c.z));
    const auto t = hn::Div(hn::Mul(depth, hn::Set(d, ray.shear_k)), sum);
    hit = hn::And(hit, hn::And(hn::Ge(t, hn::Set(d, lo)), hn::Le(t, hn::Set(d, hi))));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hit, bits);
    out.mask |= static_cast<std::uint32_t>(bits[0]) << lane;
    hn::Store(t, d, out.t + lane);
    hn::Store(u, d, out.u + lane);
    hn::Store(v, d, out.v + lane);
    hn::Store(w, d, out.w + lane);
  }
}

// Calls `take(block, crossings, lane, hi)` for every crossing in `range` until it returns true. `take` may lower `hi`.
template <bool ordered, class Take>
HWY_INLINE void for_each_crossing(const TriangleTree& tree, const Ray& ray, Interval range, Take&& take) {
  const ShearedRay sheared_ray(ray);
  const Block* const blocks = tree.blocks().data();
  std::uint64_t box_tests = 0;
  double hi = range.hi;
  traverse<ordered>(tree.bvh(), ray, depth_below(range.lo), depth_above(range.hi), box_tests,
                    [&](std::uint32_t first, std::uint32_t count, float& far) HWY_ATTR {
                      Crossings found;
                      for (const Block* block = blocks + first; block != blocks + first + count; ++block) {
                        cross(*block, sheared_ray, range.lo, hi, found);
                        for (std::uint32_t mask = found.mask; mask != 0; mask &= mask - 1) {
                          const auto lane = static_cast<std::size_t>(std::countr_zero(mask));
                          if (take(*block, found, lane, hi)) return true;
                        }
                      }
                      far = depth_above(hi);
                      return false;
                    });
}

HWY_INLINE TriangleHit hit_of(const Block& block, const Crossings& found, std::size_t lane) {
  const double sum = found.u[lane] + found.v[lane] + found.w[lane];
  return {found.t[lane], block.face[lane], {found.u[lane] / sum, found.v[lane] / sum, found.w[lane] / sum}};
}

bool nearest(const TriangleTree& tree, const Ray& ray, Interval range, TriangleHit& hit) {
  bool any_found = false;
  double u = 0, v = 0, w = 0;
  for_each_crossing<true>(tree, ray, range,
                          [&](const Block& block, const Crossings& found, std::size_t lane, double& hi) {
                            const double t = found.t[lane];
                            if (any_found && !(t < hit.t || (t == hit.t && block.face[lane] > hit.face))) return false;
                            hit.t = hi = t;
                            hit.face = block.face[lane];
                            u = found.u[lane];
                            v = found.v[lane];
                            w = found.w[lane];
                            any_found = true;
                            return false;
                          });
  if (!any_found) return false;
  const double sum = u + v + w;
  hit.weights = {u / sum, v / sum, w / sum};
  return true;
}

bool any(const TriangleTree& tree, const Ray& ray, Interval range) {
  bool any_found = false;
  for_each_crossing<false>(tree, ray, range, [&](const Block&, const Crossings&, std::size_t, double&) {
    any_found = true;
    return true;
  });
  return any_found;
}

void all(const TriangleTree& tree, const Ray& ray, Interval range, std::vector<TriangleHit>& hits) {
  for_each_crossing<false>(tree, ray, range,
                           [&](const Block& block, const Crossings& found, std::size_t lane, double&) {
                             hits.push_back(hit_of(block, found, lane));
                             return false;
                           });
}

// The sign of the edge function between two sheared corners, seen from a point that lies infinitely little beside the
// ray, at (epsilon, epsilon^2). Zero only for an edge without length.
int perturbed_sign(double edge_function, const double (&from)[2], const double (&to)[2]) {
  if (edge_function != 0) return edge_function > 0 ? 1 : -1;
  // edge(from - e, to - e) = edge(from, to) - epsilon (to.y - from.y) + epsilon^2 (to.x - from.x)
  if (to[1] != from[1]) return to[1] < from[1] ? 1 : -1;
  if (to[0] != from[0]) return to[0] > from[0] ? 1 : -1;
  return 0;
}

bool crosses_perturbed(const Block& block, const ShearedRay& ray, const Crossings& found, std::size_t lane) {
  if (found.u[lane] != 0 && found.v[lane] != 0 && found.w[lane] != 0) return true;
  double p[3][2];
  for (std::size_t c = 0; c < 3; ++c) {
    const double z = static_cast<double>(block.corner[c][ray.k][lane]) - ray.origin[2];
    p[c][0] = (static_cast<double>(block.corner[c][ray.i][lane]) - ray.origin[0]) - ray.shear_i * z;
    p[c][1] = (static_cast<double>(block.corner[c][ray.j][lane]) - ray.origin[1]) - ray.shear_j * z;
  }
  const int u = perturbed_sign(found.u[lane], p[2], p[1]);
  const int v = perturbed_sign(found.v[lane], p[0], p[2]);
  const int w = perturbed_sign(found.w[lane], p[1], p[0]);
  return u == v && v == w;
}

std::uint64_t crossings(const TriangleTree& tree, const Ray& ray, Interval range) {
  std::uint64_t count = 0;
  const ShearedRay sheared_ray(ray);
  for_each_crossing<false>(tree, ray, range,
                           [&](const Block& block, const Crossings& found, std::size_t lane, double&) {
                             if (crosses_perturbed(block, sheared_ray, found, lane)) ++count;
                             return false;
                           });
  return count;
}

}  // namespace
}  // namespace lute::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lute {
namespace {

HWY_EXPORT(nearest);
HWY_EXPORT(any);
HWY_EXPORT(all);
HWY_EXPORT(crossings);

bool is_finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

constexpr std::size_t kGrain = 4096;  // faces or leaves to a task

// The boxes of the triangles that have one: corners that are no numbers make none.
std::vector<Bvh::Item> triangle_boxes(std::span<const glm::vec3> vertices, std::span<const TriangleTree::Face> faces,
                                      std::span<const std::uint32_t> used) {
  std::vector<Bvh::Item> items(used.size());
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, used.size(), kGrain), [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
          const TriangleTree::Face& face = faces[used[i]];
          const glm::vec3 &a = vertices[face[0]], &b = vertices[face[1]], &c = vertices[face[2]];
          items[i].index =
              is_finite(a) && is_finite(b) && is_finite(c) ? used[i] : static_cast<std::uint32_t>(faces.size());
          for (int axis = 0; axis < 3; ++axis) {
            items[i].lo[axis] = std::min({a[axis], b[axis], c[axis]});
            items[i].hi[axis] = std::max({a[axis], b[axis], c[axis]});
          }
        }
      });
  std::erase_if(items, [&](const Bvh::Item& item) { return item.index == faces.size(); });
  return items;
}

}  // namespace

bool TriangleTree::nearest(const Ray& ray, Interval range, TriangleHit& hit) const {
  return HWY_DYNAMIC_DISPATCH(nearest)(*this, ray, range, hit);
}

bool TriangleTree::any(const Ray& ray, Interval range) const { return HWY_DYNAMIC_DISPATCH(any)(*this, ray, range); }

void TriangleTree::all(const Ray& ray, Interval range, std::vector<TriangleHit>& hits) const {
  HWY_DYNAMIC_DISPATCH(all)(*this, ray, range, hits);
}

std::uint64_t TriangleTree::crossings(const Ray& ray, Interval range) const {
  return HWY_DYNAMIC_DISPATCH(crossings)(*this, ray, range);
}

void TriangleTree::build(std::span<const glm::vec3> vertices, std::span<const Face> faces,
                         std::span<const std::uint32_t> used) {
  bvh_ = Bvh(triangle_boxes(vertices, faces, used), {.block = 4, .max_size = 16});
  pack_leaves(vertices, faces);
}

void TriangleTree::pack_leaves(std::span<const glm::vec3> vertices, std::span<const Face> faces) {
  struct Leaf {
    std::uint32_t first, count, block;
  };
  std::vector<Leaf> leaves;
  std::uint32_t block_count = 0;
  bvh_.replace_leaves([&](std::uint32_t first, std::uint32_t count) {
    leaves.push_back({first, count, block_count});
    const std::uint32_t blocks = (count + 3) / 4;
    block_count += blocks;
    return std::pair{leaves.back().block, blocks};
  });
  blocks_.resize(block_count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, leaves.size(), kGrain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t l = range.begin(); l < range.end(); ++l) {
                        for (std::uint32_t n = 0; n < leaves[l].count; ++n) {
                          Block& block = blocks_[leaves[l].block + n / 4];
                          const std::uint32_t lane = n % 4;
                          const std::uint32_t face = bvh_.order()[leaves[l].first + n];
                          block.face[lane] = face;
                          for (std::size_t c = 0; c < 3; ++c)
                            for (int axis = 0; axis < 3; ++axis)
                              block.corner[c][axis][lane] = vertices[faces[face][c]][axis];
                        }
                      }
                    });
}

}  // namespace lute
#endif
