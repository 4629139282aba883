// What SDL's trace() and inside() do, for tests of shapes: the nearest hit at least 1e-4 away, and the raw normal there.
#pragma once

#include <memory>
#include <optional>

#include "engine/math/transform.hpp"
#include "engine/shape/shape.hpp"

namespace lute::test {

class NoCache final : public BuildContext {
 public:
  std::shared_ptr<const void> find_shared(const void*) const override { return nullptr; }
  void store_shared(const void*, std::shared_ptr<const void>) override {}
};

struct Traced {
  double t;
  dvec3 point, normal;
};

template <class Description>
std::unique_ptr<Shape> make(const Description& description, const Transform& to_world = {}) {
  NoCache cache;
  return build(description, to_world, cache);
}

inline std::optional<Traced> trace(const Shape& shape, const dvec3& from, const dvec3& direction) {
  const Ray ray{from, glm::normalize(direction)};
  ShapeHit hit;
  if (!shape.nearest(ray, {1e-4, 1e10}, hit)) return std::nullopt;
  const dvec3 point = ray.at(hit.t);
  return Traced{hit.t, point, shape.normal(hit, point)};
}

inline double distance(const dvec3& a, const dvec3& b) { return glm::length(a - b); }

}  // namespace lute::test

#define EXPECT_TRACE(shape, from, direction, expected_point, expected_normal)            \
  do {                                                                                  \
    const auto traced_ = ::lute::test::trace(shape, from, direction);                    \
    ASSERT_TRUE(traced_.has_value());                                                    \
    EXPECT_LT(::lute::test::distance(traced_->point, expected_point), 2e-6)              \
        << traced_->point.x << ' ' << traced_->point.y << ' ' << traced_->point.z;       \
    EXPECT_LT(::lute::test::distance(traced_->normal, expected_normal), 2e-6)            \
        << traced_->normal.x << ' ' << traced_->normal.y << ' ' << traced_->normal.z;    \
  } while (false)
