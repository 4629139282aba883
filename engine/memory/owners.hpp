// How many share a value: the count that Shared and SharedVariant keep beside it. Safe for owners on several threads.
#pragma once

#include <atomic>
#include <cstdint>

namespace lute {

class Owners {
 public:
  void add() { count_.fetch_add(1, std::memory_order_relaxed); }
  bool remove_last() { return count_.fetch_sub(1, std::memory_order_acq_rel) == 1; }  // one less; true: that was the last
  bool only_one() const { return count_.load(std::memory_order_acquire) == 1; }

 private:
  std::atomic<std::uint32_t> count_{1};
};

}  // namespace lute
