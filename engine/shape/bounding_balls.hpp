// Balls around a few things, asked one after the other, four at a time: for so few the top of a tree costs more.
//
// They are kept in single precision about the middle of all, in radii of the whole, and so is the point of the ray that is nearest to
// it: at any scale, and from up to a billion radii away, what rounding does is a part of the size of the whole, which the balls are
// larger by.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "engine/math/ray.hpp"

namespace lute {

class BoundingBalls {
 public:
  struct Ball {
    dvec3 center;
    double radius;
  };

  BoundingBalls() = default;
  explicit BoundingBalls(const std::vector<Ball>& balls);

  // Calls visit(i), ascending, for all whose ball the ray's line meets, or the point is in; at times for one that it passes by.
  template <class Visit>
  void for_each_near(const Ray& ray, Visit&& visit) const;
  template <class Visit>
  void for_each_at(const dvec3& point, Visit&& visit) const;

 private:
  // Of balls without measure: none is too far away.
  void visit_all(std::size_t count);

  static constexpr std::size_t kWidth = 4;
  using Four = float __attribute__((vector_size(16)));
  struct Group {
    Four x{}, y{}, z{};
    Four square = Four{} - std::numeric_limits<float>::infinity();  // of the radius; -infinity: no ball
  };
  // Far above the rounding of single precision: of coordinates, in radii of the whole, and of squared distances.
  static constexpr double kPlaceMargin = 1e-6;
  static constexpr float kSquareMargin = 4e-6f;

  template <class Visit>
  static void visit_not_below(const Four& room, std::size_t first, Visit& visit) {
    for (std::size_t i = 0; i < kWidth; ++i)
      if (room[i] >= 0) visit(first + i);
  }

  dvec3 center_{0};
  double unit_ = 1;       // 1 / radius of a ball around all
  double farthest_ = -1;  // square, in radii, of what may be in it; negative: nothing there
  std::vector<Group> groups_;
};

inline BoundingBalls::BoundingBalls(const std::vector<Ball>& balls) : groups_((balls.size() + kWidth - 1) / kWidth) {
  if (balls.empty()) return;
  dvec3 lo(std::numeric_limits<double>::infinity()), hi = -lo;
  for (const Ball& ball : balls) {
    lo = glm::min(lo, ball.center - ball.radius);
    hi = glm::max(hi, ball.center + ball.radius);
  }
  center_ = 0.5 * (lo + hi);
  double radius = 0;
  for (const Ball& ball : balls) radius = std::max(radius, glm::length(ball.center - center_) + ball.radius);
  if (!(radius * radius < std::numeric_limits<double>::max())) {
    visit_all(balls.size());
    return;
  }
  if (radius > 0) unit_ = 1 / radius;
  farthest_ = 1 + kPlaceMargin;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const dvec3 place = (balls[i].center - center_) * unit_;
    const double wider = balls[i].radius * unit_ + kPlaceMargin;
    Group& group = groups_[i / kWidth];
    group.x[i % kWidth] = static_cast<float>(place.x);
    group.y[i % kWidth] = static_cast<float>(place.y);
    group.z[i % kWidth] = static_cast<float>(place.z);
    group.square[i % kWidth] = static_cast<float>(wider * wider) * (1 + kSquareMargin);
  }
}

inline void BoundingBalls::visit_all(std::size_t count) {
  center_ = dvec3(0);
  unit_ = 0;
  farthest_ = 1;
  for (std::size_t i = 0; i < count; ++i) groups_[i / kWidth].square[i % kWidth] = std::numeric_limits<float>::infinity();
}

template <class Visit>
void BoundingBalls::for_each_near(const Ray& ray, Visit&& visit) const {
  const dvec3 from = (ray.origin - center_) * unit_, d = ray.direction / glm::length(ray.direction);
  const dvec3 p = from - glm::dot(from, d) * d;
  if (!(glm::dot(p, p) <= farthest_)) return;
  const auto px = static_cast<float>(p.x), py = static_cast<float>(p.y), pz = static_cast<float>(p.z);
  const auto dx = static_cast<float>(d.x), dy = static_cast<float>(d.y), dz = static_cast<float>(d.z);
  std::size_t first = 0;
  for (const Group& group : groups_) {
    const Four x = group.x - px, y = group.y - py, z = group.z - pz;
    const Four along = x * dx + y * dy + z * dz, far = x * x + y * y + z * z;
    visit_not_below(group.square + along * along - far * (1 - kSquareMargin), first, visit);
    first += kWidth;
  }
}

template <class Visit>
void BoundingBalls::for_each_at(const dvec3& point, Visit&& visit) const {
  const dvec3 p = (point - center_) * unit_;
  if (!(glm::dot(p, p) <= farthest_)) return;
  const auto px = static_cast<float>(p.x), py = static_cast<float>(p.y), pz = static_cast<float>(p.z);
  std::size_t first = 0;
  for (const Group& group : groups_) {
    const Four x = group.x - px, y = group.y - py, z = group.z - pz;
    visit_not_below(group.square - (x * x + y * y + z * z), first, visit);
    first += kWidth;
  }
}

}  // namespace lute
