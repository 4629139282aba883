// A value that its copies share: whoever edits it gets one of his own first. One pointer large, and nothing more for the default value.
#pragma once

#include <atomic>
#include <cstdint>
#include <utility>

namespace lute {

template <class T>
class Shared {
 public:
  Shared() = default;  // T{}
  Shared(T value) : block_(new Block{{1}, std::move(value)}) {}
  Shared(const Shared& other) : block_(other.block_) {
    if (block_ != nullptr) block_->owners.fetch_add(1, std::memory_order_relaxed);
  }
  Shared(Shared&& other) noexcept : block_(std::exchange(other.block_, nullptr)) {}
  Shared& operator=(Shared other) noexcept {
    std::swap(block_, other.block_);
    return *this;
  }
  ~Shared() {
    if (block_ != nullptr && block_->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) delete block_;
  }

  const T& operator*() const {
    static const T default_value{};
    return block_ != nullptr ? block_->value : default_value;
  }
  const T* operator->() const { return &**this; }
  operator const T&() const { return **this; }

  // For changes that no copy sees.
  T& edit() {
    if (block_ == nullptr || block_->owners.load(std::memory_order_acquire) != 1) *this = Shared(T(**this));
    return block_->value;
  }

  bool is_default() const { return block_ == nullptr; }  // nobody has set or edited it
  bool shares(const Shared& other) const { return block_ == other.block_; }

 private:
  struct Block {
    std::atomic<std::uint32_t> owners;
    T value;
  };
  Block* block_ = nullptr;
};

}  // namespace lute
