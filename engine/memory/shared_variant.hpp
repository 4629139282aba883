// One of several types, shared by its copies as Shared is. Unlike std::variant it takes no more memory than the alternative it holds.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "engine/memory/owners.hpp"

namespace lute {

template <class... Alternatives>
class SharedVariant {
  template <class T>
  static constexpr bool kHolds = (std::same_as<T, Alternatives> || ...);

 public:
  template <class T>
    requires kHolds<T>
  SharedVariant(T value) : head_(new Block<T>{{{}, index_of<T>()}, std::move(value)}) {}
  SharedVariant(const SharedVariant& other) : head_(other.head_) {
    if (head_ != nullptr) head_->owners.add();
  }
  SharedVariant(SharedVariant&& other) noexcept : head_(std::exchange(other.head_, nullptr)) {}
  SharedVariant& operator=(SharedVariant other) noexcept {
    std::swap(head_, other.head_);
    return *this;
  }
  ~SharedVariant() {
    if (head_ == nullptr || !head_->owners.remove_last()) return;
    visit([this]<class T>(const T&) { delete static_cast<Block<T>*>(head_); });
  }

  template <class T>
    requires kHolds<T>
  const T* get_if() const {
    return head_->index == index_of<T>() ? &static_cast<const Block<T>*>(head_)->value : nullptr;
  }

  // Calls f(const T&) with what it holds.
  template <class F>
  decltype(auto) visit(F&& f) const {
    using Result = std::common_type_t<std::invoke_result_t<F&, const Alternatives&>...>;
    using Call = Result (*)(F&, const Head&);
    static constexpr std::array<Call, sizeof...(Alternatives)> kCalls{
        [](F& function, const Head& head) -> Result { return function(static_cast<const Block<Alternatives>&>(head).value); }...};
    return kCalls[head_->index](f, *head_);
  }

  // Calls f(T&), whose changes no copy sees.
  template <class F>
  decltype(auto) edit(F&& f) {
    if (!head_->owners.only_one())
      *this = visit([]<class T>(const T& value) { return SharedVariant(T(value)); });
    return visit([&]<class T>(const T&) { return f(static_cast<Block<T>*>(head_)->value); });
  }

 private:
  struct Head {
    Owners owners;
    std::uint32_t index;
  };
  template <class T>
  struct Block : Head {
    T value;
  };

  template <class T>
  static constexpr std::uint32_t index_of() {
    std::uint32_t index = 0;
    static_cast<void>(((std::same_as<T, Alternatives> || (++index, false)) || ...));
    return index;
  }

  Head* head_;
};

}  // namespace lute
