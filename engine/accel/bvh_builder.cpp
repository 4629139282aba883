#include "engine/accel/bvh_builder.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

// Compiled once for each instruction set; the best one is chosen at run time. Minima, maxima and counts are exact in
// any order and on any instruction set, so the tree is always the same.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/accel/bvh_builder.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace lute::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::uint32_t kMaxBins = 16;
constexpr std::size_t kParallelSubtree = 8192;  // items; smaller subtrees are not worth a task
constexpr std::size_t kParallelBinning = 65536;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

#if HWY_TARGET == HWY_SCALAR
struct Vec4 {
  float v[4];
};
inline Vec4 load(const float* p) { return {{p[0], p[1], p[2], p[3]}}; }
inline Vec4 load_three(const float* p) { return {{p[0], p[1], p[2], 0}}; }
inline void store(Vec4 a, float* p) { std::memcpy(p, a.v, sizeof a.v); }
template <class F>
Vec4 each(Vec4 a, Vec4 b, F f) {
  return {{f(a.v[0], b.v[0]), f(a.v[1], b.v[1]), f(a.v[2], b.v[2]), f(a.v[3], b.v[3])}};
}
inline Vec4 least(Vec4 a, Vec4 b) {
  return each(a, b, [](float x, float y) { return x < y ? x : y; });
}
inline Vec4 greatest(Vec4 a, Vec4 b) {
  return each(a, b, [](float x, float y) { return x > y ? x : y; });
}
inline Vec4 sum(Vec4 a, Vec4 b) {
  return each(a, b, [](float x, float y) { return x + y; });
}
inline void bin_numbers(Vec4 center, const float* base, const float* scale, std::int32_t* out) {
  for (int i = 0; i < 3; ++i) out[i] = static_cast<std::int32_t>((center.v[i] - base[i]) * scale[i]);
}
#else
using D4 = hn::FixedTag<float, 4>;
using Vec4 = hn::Vec<D4>;
HWY_INLINE Vec4 load(const float* p) { return hn::Load(D4(), p); }
HWY_INLINE Vec4 load_three(const float* p) {
  alignas(16) static constexpr std::uint32_t kFirstThree[4] = {~0u, ~0u, ~0u, 0};
  return hn::And(load(p), hn::BitCast(D4(), hn::Load(hn::FixedTag<std::uint32_t, 4>(), kFirstThree)));
}
HWY_INLINE void store(Vec4 a, float* p) { hn::Store(a, D4(), p); }
HWY_INLINE Vec4 least(Vec4 a, Vec4 b) { return hn::Min(a, b); }
HWY_INLINE Vec4 greatest(Vec4 a, Vec4 b) { return hn::Max(a, b); }
HWY_INLINE Vec4 sum(Vec4 a, Vec4 b) { return hn::Add(a, b); }
HWY_INLINE void bin_numbers(Vec4 center, const float* base, const float* scale, std::int32_t* out) {
  hn::Store(hn::ConvertTo(hn::FixedTag<std::int32_t, 4>(), hn::Mul(hn::Sub(center, load(base)), load(scale))),
            hn::FixedTag<std::int32_t, 4>(), out);
}
#endif

// Four floats an end, of which the fourth is not used.
struct alignas(16) Box {
  float lo[4] = {kInfinity, kInfinity, kInfinity, 0};
  float hi[4] = {-kInfinity, -kInfinity, -kInfinity, 0};

  void join(const Box& b) {
    store(least(load(lo), load(b.lo)), lo);
    store(greatest(load(hi), load(b.hi)), hi);
  }
  void join(Vec4 b_lo, Vec4 b_hi) {
    store(least(load(lo), b_lo), lo);
    store(greatest(load(hi), b_hi), hi);
  }
  double half_area() const {
    const double x = static_cast<double>(hi[0]) - static_cast<double>(lo[0]);
    const double y = static_cast<double>(hi[1]) - static_cast<double>(lo[1]);
    const double z = static_cast<double>(hi[2]) - static_cast<double>(lo[2]);
    return x >= 0 ? x * y + y * z + z * x : 0;
  }
};

// The ends of an item's box; the fourth component, where the item keeps its index, reads as 0.
HWY_INLINE Vec4 low(const Bvh::Item& item) { return load_three(reinterpret_cast<const float*>(&item)); }
HWY_INLINE Vec4 high(const Bvh::Item& item) { return load_three(reinterpret_cast<const float*>(&item) + 4); }

struct Range {
  std::size_t begin = 0, end = 0;
  Box box, centers;   // of the items; of their centres, doubled
  bool leaf = false;  // not to be split further
  std::size_t size() const { return end - begin; }
  void join(const Bvh::Item& item) {
    const Vec4 lo = low(item), hi = high(item), center = sum(lo, hi);
    box.join(lo, hi);
    centers.join(center, center);
  }
};

// Which bin of each axis an item's centre falls into.
struct Binning {
  alignas(16) float base[4], scale[4];
  std::uint32_t bins;
  explicit Binning(const Range& range)
      : bins(static_cast<std::uint32_t>(std::min<std::size_t>(kMaxBins, 4 + range.size() / 16))) {
    for (std::size_t a = 0; a < 4; ++a) {
      const float extent = a < 3 ? range.centers.hi[a] - range.centers.lo[a] : 0;
      base[a] = a < 3 ? range.centers.lo[a] : 0;
      // Just below `bins`, so that the farthest centre stays in the last one. A flat axis has one bin only.
      scale[a] = extent > 0 ? std::min(0.9999f * static_cast<float>(bins) / extent, 1e37f) : 0;
    }
  }
  HWY_INLINE void operator()(const Bvh::Item& item, std::int32_t* out) const {
    bin_numbers(sum(low(item), high(item)), base, scale, out);
  }
};

struct Bins {
  Box box[3][kMaxBins];
  std::uint32_t count[3][kMaxBins] = {};

  void add(const Bvh::Item* items, std::size_t begin, std::size_t end, const Binning& binning) {
    for (std::size_t i = begin; i < end; ++i) {
      alignas(16) std::int32_t bin[4];
      binning(items[i], bin);
      const Vec4 lo = low(items[i]), hi = high(items[i]);
      for (std::size_t a = 0; a < 3; ++a) {
        box[a][bin[a]].join(lo, hi);
        ++count[a][bin[a]];
      }
    }
  }
  void add(const Bins& other, std::uint32_t bins) {
    for (std::size_t a = 0; a < 3; ++a)
      for (std::uint32_t b = 0; b < bins; ++b) {
        box[a][b].join(other.box[a][b]);
        count[a][b] += other.count[a][b];
      }
  }
};

struct Split {
  double cost = std::numeric_limits<double>::infinity();
  std::size_t axis = 0;
  std::int32_t bin = 0;  // the first of the right side
};

class Builder {
 public:
  Builder(std::vector<Bvh::Item>& items, BvhLeaves leaves) : items_(items.data()), leaves_(leaves) {}

  void build(std::size_t size, std::vector<Bvh::Node>& nodes) {
    Range all;
    all.end = size;
    for (std::size_t i = 0; i < size; ++i) all.join(items_[i]);
    nodes.reserve(enough_nodes(size));
    node(all, 0, nodes);
  }

 private:
  // More than there will be, mostly: what is not used takes no memory, moving what is used takes twice as much.
  std::size_t enough_nodes(std::size_t items) const { return items / (4 * leaves_.block) + 1; }
  double blocks(std::size_t count) const { return static_cast<double>((count + leaves_.block - 1) / leaves_.block); }

  // Appends the node over `range`, then those below it, to `out`.
  void node(const Range& range, int depth, std::vector<Bvh::Node>& out) {
    std::array<Range, Bvh::kWidth> parts{range};
    const std::size_t count = divide(parts, depth);

    const std::size_t index = out.size();
    out.emplace_back();
    for (std::size_t c = 0; c < Bvh::kWidth; ++c) {
      const Box box = c < count ? parts[c].box : Box();
      for (std::size_t a = 0; a < 3; ++a) {
        out[index].lo[a][c] = box.lo[a];
        out[index].hi[a][c] = box.hi[a];
      }
      out[index].child[c] = 0;
      out[index].count[c] = 0;
      if (c >= count) continue;
      if (is_leaf(parts[c])) {
        out[index].child[c] = ~static_cast<std::int32_t>(parts[c].begin);
        out[index].count[c] = static_cast<std::uint32_t>(parts[c].size());
      } else if (parts[c].size() < kParallelSubtree) {
        out[index].child[c] = static_cast<std::int32_t>(out.size());
        node(parts[c], depth + 1, out);
      }
    }
    for (std::size_t c = 0; c < count;) c = large_subtrees(parts, c, count, depth, index, out);
  }

  // Builds some of the large subtrees of a node in parallel, from child `c` on; returns where to go on. Each stands in memory twice
  // until it is in its place, so that there are no more at a time than keep all threads busy.
  std::size_t large_subtrees(const std::array<Range, Bvh::kWidth>& parts, std::size_t c, std::size_t count, int depth, std::size_t index,
                             std::vector<Bvh::Node>& out) {
    const auto most = 2 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    std::array<std::vector<Bvh::Node>, Bvh::kWidth> subtrees;
    tbb::task_group tasks;
    const std::size_t first = c;
    for (std::size_t begun = 0; c < count && begun < most; ++c) {
      if (is_leaf(parts[c]) || parts[c].size() < kParallelSubtree) continue;
      ++begun;
      tasks.run([this, &part = parts[c], &subtree = subtrees[c], depth] {
        subtree.reserve(enough_nodes(part.size()));
        node(part, depth + 1, subtree);
      });
    }
    tasks.wait();
    for (std::size_t i = first; i < c; ++i)
      if (!subtrees[i].empty()) out[index].child[i] = append(std::exchange(subtrees[i], {}), out);
    return c;
  }

  static std::int32_t append(const std::vector<Bvh::Node>& subtree, std::vector<Bvh::Node>& out) {
    const auto offset = static_cast<std::int32_t>(out.size());
    for (const Bvh::Node& node : subtree) {
      out.push_back(node);
      for (std::size_t c = 0; c < Bvh::kWidth; ++c)
        if (node.child[c] > 0) out.back().child[c] += offset;  // 0 is the root, nobody's child: an empty slot
    }
    return offset;
  }

  bool is_leaf(const Range& range) const { return range.leaf || range.size() <= leaves_.block; }

  // Splits `parts[0]` into up to eight; returns how many there are. Nodes come out well filled: what one node holds is divided no
  // further, unless there is room for all of it here.
  std::size_t divide(std::array<Range, Bvh::kWidth>& parts, int depth) {
    const std::size_t full = Bvh::kWidth * leaves_.block;
    std::size_t count = 1;
    const auto split_best = [&](auto&& worth) {
      std::size_t best = Bvh::kWidth;
      double most = 0;
      for (std::size_t i = 0; i < count; ++i) {
        if (is_leaf(parts[i])) continue;
        const double w = worth(parts[i]);
        if (!(w > most)) continue;
        most = w;
        best = i;
      }
      if (best < Bvh::kWidth && split(parts[best], parts[count], depth)) ++count;
      return best < Bvh::kWidth;
    };
    // The surface decides; one that is not even zero (of boxes without extent) still counts.
    const auto surface = [&](const Range& part) { return part.size() > full ? 1e-300 + part.box.half_area() : 0; };
    while (count < Bvh::kWidth && split_best(surface)) {
    }
    const auto smallness = [&](const Range& part) {
      const double leaves = blocks(part.size());
      return leaves - 1 <= static_cast<double>(Bvh::kWidth - count) ? 1 / leaves : 0;
    };
    while (count < Bvh::kWidth && split_best(smallness)) {
    }
    return count;
  }

  // Moves the right half of `left` into `right`; or finds that `left` had better be a leaf.
  bool split(Range& left, Range& right, int depth) {
    const Binning binning(left);
    Split best;
    // Halving by count bounds the depth, whatever the items look like.
    if (depth < Bvh::kMaxDepth / 2) best = best_split(left, binning);
    const bool fits = left.size() <= leaves_.max_size;
    const double area = left.box.half_area();
    if (fits && !(best.cost + area < area * blocks(left.size()))) {
      left.leaf = true;
      return false;
    }
    const std::size_t middle = best.cost < std::numeric_limits<double>::infinity()
                                   ? partition(left, binning, best, right)
                                   : halve(left, right);
    right.begin = middle;
    right.end = left.end;
    right.leaf = false;
    left.end = middle;
    return true;
  }

  Split best_split(const Range& range, const Binning& binning) const {
    Bins bins;
    if (range.size() < kParallelBinning) {
      bins.add(items_, range.begin, range.end, binning);
    } else {
      bins = tbb::parallel_reduce(
          tbb::blocked_range<std::size_t>(range.begin, range.end, kParallelBinning / 8), Bins(),
          [&](const tbb::blocked_range<std::size_t>& r, Bins part) {
            part.add(items_, r.begin(), r.end(), binning);
            return part;
          },
          [&](Bins a, const Bins& b) {
            a.add(b, binning.bins);
            return a;
          });
    }
    Split best;
    for (std::size_t a = 0; a < 3; ++a)
      if (binning.scale[a] > 0) best_split_of_axis(bins, binning.bins, a, range.size(), best);
    return best;
  }

  void best_split_of_axis(const Bins& bins, std::uint32_t bin_count, std::size_t axis, std::size_t size,
                          Split& best) const {
    std::array<double, kMaxBins> right_cost{};
    Box box;
    std::size_t count = 0;
    for (std::uint32_t b = bin_count - 1; b > 0; --b) {
      box.join(bins.box[axis][b]);
      count += bins.count[axis][b];
      right_cost[b] = box.half_area() * blocks(count);
    }
    box = Box();
    count = 0;
    for (std::uint32_t b = 1; b < bin_count; ++b) {
      box.join(bins.box[axis][b - 1]);
      count += bins.count[axis][b - 1];
      if (count == 0 || count == size) continue;
      const double cost = box.half_area() * blocks(count) + right_cost[b];
      if (cost < best.cost) best = {cost, axis, static_cast<std::int32_t>(b)};
    }
  }

  // Both return where the right side begins, and find the boxes of both sides.
  std::size_t partition(Range& left, const Binning& binning, const Split& split, Range& right) {
    Range l, r;
    std::size_t i = left.begin, j = left.end;
    const auto goes_left = [&](const Bvh::Item& item) {
      alignas(16) std::int32_t bin[4];
      binning(item, bin);
      return bin[split.axis] < split.bin;
    };
    for (;;) {
      while (i < j && goes_left(items_[i])) l.join(items_[i++]);
      while (i < j && !goes_left(items_[j - 1])) r.join(items_[--j]);
      if (i >= j) break;
      std::swap(items_[i], items_[j - 1]);
    }
    take_boxes(l, left);
    take_boxes(r, right);
    return i;
  }

  std::size_t halve(Range& left, Range& right) {
    std::size_t axis = 0;
    for (std::size_t a = 1; a < 3; ++a)
      if (left.centers.hi[a] - left.centers.lo[a] > left.centers.hi[axis] - left.centers.lo[axis]) axis = a;
    const std::size_t middle = left.begin + left.size() / 2;
    std::nth_element(items_ + left.begin, items_ + middle, items_ + left.end,
                     [axis](const Bvh::Item& a, const Bvh::Item& b) {
                       const float ca = a.lo[axis] + a.hi[axis], cb = b.lo[axis] + b.hi[axis];
                       return ca < cb || (ca == cb && a.index < b.index);
                     });
    Range l, r;
    for (std::size_t i = left.begin; i < middle; ++i) l.join(items_[i]);
    for (std::size_t i = middle; i < left.end; ++i) r.join(items_[i]);
    take_boxes(l, left);
    take_boxes(r, right);
    return middle;
  }

  static void take_boxes(const Range& from, Range& to) {
    to.box = from.box;
    to.centers = from.centers;
  }

  Bvh::Item* items_;
  BvhLeaves leaves_;
};

void build_nodes(std::vector<Bvh::Item>& items, BvhLeaves leaves, std::vector<Bvh::Node>& nodes) {
  Builder(items, leaves).build(items.size(), nodes);
}

}  // namespace
}  // namespace lute::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lute {

HWY_EXPORT(build_nodes);

std::vector<Bvh::Node> build_bvh_nodes(std::vector<Bvh::Item>& items, BvhLeaves leaves) {
  std::vector<Bvh::Node> nodes;
  leaves.max_size = std::max(leaves.max_size, leaves.block);
  if (!items.empty()) HWY_DYNAMIC_DISPATCH(build_nodes)(items, leaves, nodes);
  return nodes;
}

}  // namespace lute
#endif
