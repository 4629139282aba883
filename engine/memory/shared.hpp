// A value that its copies share: whoever edits it gets one of his own first. One pointer large, and nothing more for the default value.
#pragma once

#include <utility>

#include "engine/memory/owners.hpp"

namespace lute {

template <class T>
class Shared {
 public:
  Shared() = default;  // T{}
  Shared(T value) : block_(new Block{{}, std::move(value)}) {}
  Shared(const Shared& other) : block_(other.block_) {
    if (block_ != nullptr) block_->owners.add();
  }
  Shared(Shared&& other) noexcept : block_(std::exchange(other.block_, nullptr)) {}
  Shared& operator=(Shared other) noexcept {
    std::swap(block_, other.block_);
    return *this;
  }
  ~Shared() {
    if (block_ != nullptr && block_->owners.remove_last()) delete block_;
  }

  const T& operator*() const { return block_ != nullptr ? block_->value : default_value(); }
  const T* operator->() const { return &**this; }
  operator const T&() const { return **this; }

  // For changes that no copy sees.
  T& edit() {
    if (block_ == nullptr || !block_->owners.only_one()) *this = Shared(T(**this));
    return block_->value;
  }

  bool is_default() const { return block_ == nullptr; }  // nobody has set or edited it
  bool shares(const Shared& other) const { return block_ == other.block_; }

 private:
  struct Block {
    Owners owners;
    T value;
  };

  static const T& default_value() {
    static const T value{};
    return value;
  }

  Block* block_ = nullptr;
};

}  // namespace lute
