// The interiors that a ray is in, in the order of entry (specification chapter 40 §9.1).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace lute {

struct BuiltInterior;

// Short lists, nearly always: kept in place, so that a ray can be copied without touching the heap.
class InteriorList {
 public:
  InteriorList() {}  // places beyond the size stay unwritten
  InteriorList(const InteriorList& other) { *this = other; }
  InteriorList& operator=(const InteriorList& other) {
    if (this == &other) return *this;
    size_ = other.size_;
    if (!spilled_.empty() || !other.spilled_.empty()) spilled_ = other.spilled_;
    for (std::size_t i = 0; i < std::min(size_, kInPlace); ++i) in_place_[i] = other.in_place_[i];
    return *this;
  }

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  std::span<const BuiltInterior* const> view() const { return {size_ <= kInPlace ? in_place_.data() : spilled_.data(), size_}; }
  const BuiltInterior* back() const { return view().back(); }

  bool contains(const BuiltInterior* interior) const {
    const auto all = view();
    return std::find(all.begin(), all.end(), interior) != all.end();
  }

  void append(const BuiltInterior* interior) {
    if (size_ < kInPlace) {
      in_place_[size_++] = interior;
      return;
    }
    if (size_ == kInPlace) spilled_.assign(in_place_.begin(), in_place_.end());
    spilled_.push_back(interior);
    ++size_;
  }

  // Removes the first occurrence. False: it is not in the list.
  bool remove(const BuiltInterior* interior) {
    const BuiltInterior** all = size_ <= kInPlace ? in_place_.data() : spilled_.data();
    const BuiltInterior** end = all + size_;
    const BuiltInterior** at = std::find(all, end, interior);
    if (at == end) return false;
    std::copy(at + 1, end, at);
    if (size_ > kInPlace) {
      spilled_.pop_back();
      if (size_ == kInPlace + 1) std::copy(spilled_.begin(), spilled_.end(), in_place_.begin());
    }
    --size_;
    return true;
  }

 private:
  static constexpr std::size_t kInPlace = 8;
  std::size_t size_ = 0;
  std::array<const BuiltInterior*, kInPlace> in_place_;
  std::vector<const BuiltInterior*> spilled_;
};

}  // namespace lute
