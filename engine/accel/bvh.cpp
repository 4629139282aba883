#include "engine/accel/bvh.hpp"

#include <algorithm>
#include <numeric>

namespace lute {
namespace {

constexpr int kBins = 16;
constexpr int kMaxDepth = 60;  // beyond it ranges are halved by count, so the traversal's stack is never exceeded

float rounded_down(double v) {
  const float f = static_cast<float>(v);
  return static_cast<double>(f) <= v ? f : std::nextafter(f, -std::numeric_limits<float>::infinity());
}
float rounded_up(double v) {
  const float f = static_cast<float>(v);
  return static_cast<double>(f) >= v ? f : std::nextafter(f, std::numeric_limits<float>::infinity());
}

}  // namespace

class BvhBuilder {
 public:
  BvhBuilder(Bvh& bvh, std::span<const Aabb> boxes, std::uint32_t leaf_size) : bvh_(bvh), boxes_(boxes), leaf_size_(leaf_size) {}

  void build() {
    auto& order = bvh_.order_;
    for (std::uint32_t i = 0; i < boxes_.size(); ++i)
      if (!boxes_[i].empty()) order.push_back(i);
    if (order.empty()) return;
    bvh_.nodes_.reserve(order.size() / 2 + 1);
    node({0, static_cast<std::uint32_t>(order.size())}, 0);
  }

 private:
  struct Range {
    std::uint32_t begin, end;
    std::uint32_t size() const { return end - begin; }
  };

  Aabb box_of(Range r) const {
    Aabb box;
    for (std::uint32_t i = r.begin; i < r.end; ++i) box.join(boxes_[bvh_.order_[i]]);
    return box;
  }

  // Emits a node over `range` and returns its index.
  std::int32_t node(Range range, int depth) {
    const auto index = bvh_.nodes_.size();
    bvh_.nodes_.emplace_back();
    // Split the largest part until there are four.
    std::array<Range, 4> parts{range};
    int count = 1;
    while (count < 4) {
      int largest = -1;
      double area = -1;
      for (int i = 0; i < count; ++i)
        if (const double a = box_of(parts[static_cast<std::size_t>(i)]).half_area();
            parts[static_cast<std::size_t>(i)].size() > leaf_size_ && a > area) {
          area = a;
          largest = i;
        }
      if (largest < 0) break;
      Range& part = parts[static_cast<std::size_t>(largest)];
      const std::uint32_t middle = split(part, depth);
      parts[static_cast<std::size_t>(count++)] = {middle, part.end};
      part.end = middle;
    }
    for (std::size_t c = 0; c < 4; ++c) {
      const bool used = static_cast<int>(c) < count;
      const Aabb box = used ? box_of(parts[c]) : Aabb{};
      for (int a = 0; a < 3; ++a) {
        bvh_.nodes_[index].lo[a][c] = used ? rounded_down(box.lo[a]) : std::numeric_limits<float>::infinity();
        bvh_.nodes_[index].hi[a][c] = used ? rounded_up(box.hi[a]) : -std::numeric_limits<float>::infinity();
      }
      if (!used) continue;
      if (parts[c].size() <= leaf_size_) {
        bvh_.nodes_[index].child[c] = ~static_cast<std::int32_t>(parts[c].begin);
        bvh_.nodes_[index].count[c] = parts[c].size();
      } else {
        const std::int32_t child = node(parts[c], depth + 1);  // may move the nodes
        bvh_.nodes_[index].child[c] = child;
      }
    }
    return static_cast<std::int32_t>(index);
  }

  // Reorders the range and returns where its second half begins.
  std::uint32_t split(Range range, int depth) {
    auto& order = bvh_.order_;
    const auto first = order.begin() + range.begin, last = order.begin() + range.end;
    Aabb centers;
    for (auto i = first; i != last; ++i) centers.join(boxes_[*i].center());
    const dvec3 size = centers.hi - centers.lo;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto halve = [&] {
      const auto middle = first + (last - first) / 2;
      std::nth_element(first, middle, last, [&](std::uint32_t a, std::uint32_t b) {
        const double ca = boxes_[a].center()[axis], cb = boxes_[b].center()[axis];
        return ca < cb || (ca == cb && a < b);
      });
      return static_cast<std::uint32_t>(middle - order.begin());
    };
    if (depth >= kMaxDepth / 4 || !(size[axis] > 0)) return halve();

    struct Bin {
      Aabb box;
      std::uint32_t count = 0;
    };
    std::array<Bin, kBins> bins{};
    const double scale = kBins / size[axis];
    const auto bin_of = [&](std::uint32_t item) {
      return static_cast<std::size_t>(std::clamp((boxes_[item].center()[axis] - centers.lo[axis]) * scale, 0.0, kBins - 1.0));
    };
    for (auto i = first; i != last; ++i) {
      Bin& bin = bins[bin_of(*i)];
      bin.box.join(boxes_[*i]);
      ++bin.count;
    }
    std::array<double, kBins> left_cost{};
    Aabb box;
    std::uint32_t count = 0;
    for (std::size_t b = 0; b + 1 < kBins; ++b) {
      box.join(bins[b].box);
      count += bins[b].count;
      left_cost[b] = box.half_area() * count;
    }
    box = Aabb{};
    count = 0;
    double best = std::numeric_limits<double>::infinity();
    std::size_t best_bin = 0;
    for (std::size_t b = kBins - 1; b > 0; --b) {
      box.join(bins[b].box);
      count += bins[b].count;
      const double cost = left_cost[b - 1] + box.half_area() * count;
      if (count > 0 && count < range.size() && cost < best) {
        best = cost;
        best_bin = b;
      }
    }
    if (best_bin == 0) return halve();
    const auto middle = std::partition(first, last, [&](std::uint32_t item) { return bin_of(item) < best_bin; });
    return static_cast<std::uint32_t>(middle - order.begin());
  }

  Bvh& bvh_;
  std::span<const Aabb> boxes_;
  std::uint32_t leaf_size_;
};

Bvh::Bvh(std::span<const Aabb> boxes, std::uint32_t leaf_size) { BvhBuilder(*this, boxes, leaf_size).build(); }

}  // namespace lute
