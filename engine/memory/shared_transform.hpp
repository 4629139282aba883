// A transformation shared by all that it moves: an object's description, its shape, its texture. The identity takes no memory.
#pragma once

#include "engine/math/transform.hpp"
#include "engine/memory/shared.hpp"

namespace lute {

class SharedTransform {
 public:
  SharedTransform() = default;  // identity
  SharedTransform(const Transform& transform) {
    if (!transform.identity()) value_ = transform;
  }

  const Transform& operator*() const { return *value_; }
  const Transform* operator->() const { return &*value_; }
  operator const Transform&() const { return *value_; }

  bool identity() const { return value_.is_default(); }
  bool shares(const SharedTransform& other) const { return value_.shares(other.value_); }

  // First this, then `next`.
  SharedTransform then(const SharedTransform& next) const {
    if (identity()) return next;
    return next.identity() ? *this : SharedTransform(value_->then(*next));
  }

 private:
  Shared<Transform> value_;
};

}  // namespace lute
