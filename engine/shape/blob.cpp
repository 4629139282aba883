#include "engine/shape/blob.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "engine/accel/bvh.hpp"
#include "engine/math/root_walk.hpp"
#include "engine/shape/axis_frame.hpp"
#include "engine/shape/bounding_balls.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

constexpr double kNearest = 1e-2;        // in world units; for blobs smaller than 1, in their size
constexpr double kInsideTolerance = 1e-6;

// A piece of a component, in a space where its radius is 1 and, of the pieces of a cylinder, the axis is z from 0 to 1.
enum class Piece : std::uint8_t { kBall, kSide, kBaseBall, kApexBall };

struct Element {
  Piece piece;
  std::uint32_t component;
  double strength;
  Transform to_world;
  // Of a ball that is round in the world too; otherwise 0.
  double radius = 0, reciprocal_square = 0;

  dvec3 radial(const dvec3& p) const { return piece == Piece::kSide ? dvec3(p.x, p.y, 0) : p; }
  bool in_part(double z) const {
    switch (piece) {
      case Piece::kBall: return true;
      case Piece::kSide: return z >= 0 && z <= 1;
      case Piece::kBaseBall: return z <= 0;
      case Piece::kApexBall: break;
    }
    return z >= 0;
  }
  // 1 - ρ²/r², or a negative number outside of the support.
  double closeness(const dvec3& local) const {
    if (!in_part(local.z)) return -1;
    const dvec3 r = radial(local);
    return 1 - glm::dot(r, r);
  }
};

// An element as the ray sees it: closeness c[0] + c[1] t + c[2] t² from `begin`, within [begin, end].
struct Stretch {
  double begin, end;
  double strength;
  double most;  // density that it may add
  std::array<double, 3> c;
};

double most_density(double strength, double closeness) { return strength > 0 ? strength * closeness * closeness : 0; }

// What all elements ask of a ray.
struct BlobRay {
  Ray ray;
  double square, reciprocal_square;  // of the length of its direction

  explicit BlobRay(const Ray& r) : ray(r), square(glm::dot(r.direction, r.direction)), reciprocal_square(1 / square) {}
};

// The depths where the ray is in a ball that is round in the world.
bool cross_ball(const Element& e, const BlobRay& r, Interval range, Stretch& out) {
  const dvec3 d = r.ray.direction, p = r.ray.origin - e.to_world.translation;
  const double middle = -glm::dot(p, d) * r.reciprocal_square;
  const dvec3 nearest = p + middle * d;
  const double h = 1 - glm::dot(nearest, nearest) * e.reciprocal_square;
  if (!(h > 0)) return false;
  const double half = e.radius * std::sqrt(h * r.reciprocal_square);
  const double begin = std::max(range.lo, middle - half), end = std::min(range.hi, middle + half);
  if (!(begin < end)) return false;
  const dvec3 q = p + begin * d;
  out = {begin, end, e.strength, most_density(e.strength, h),
         {1 - glm::dot(q, q) * e.reciprocal_square, -2 * glm::dot(q, d) * e.reciprocal_square, -r.square * e.reciprocal_square}};
  return true;
}

// The same of any other element.
bool cross_element(const Element& e, const Ray& ray, Interval range, Stretch& out) {
  const Ray local = e.to_world.inverse_ray(ray);
  const dvec3 p = e.radial(local.origin);
  const dvec3 d = e.radial(local.direction);
  const double a = glm::dot(d, d);
  double begin = range.lo;
  double end = range.hi;
  double most = most_density(e.strength, 1);
  if (a > 0) {
    const double middle = -glm::dot(p, d) / a;
    const dvec3 nearest = p + middle * d;
    const double h = 1 - glm::dot(nearest, nearest);
    if (!(h > 0)) return false;
    most = most_density(e.strength, h);
    const double half = std::sqrt(h / a);
    begin = std::max(begin, middle - half);
    end = std::min(end, middle + half);
  } else if (!(glm::dot(p, p) < 1)) {
    return false;
  }
  if (e.piece != Piece::kBall) {
    const double z = local.origin.z;
    const double dz = local.direction.z;
    const double lo = e.piece == Piece::kBaseBall ? -std::numeric_limits<double>::infinity() : 0;
    const double hi = e.piece == Piece::kSide        ? 1
                      : e.piece == Piece::kBaseBall ? 0
                                                    : std::numeric_limits<double>::infinity();
    if (dz == 0) {
      if (z < lo || z > hi) return false;
    } else {
      const double t0 = (lo - z) / dz;
      const double t1 = (hi - z) / dz;
      begin = std::max(begin, std::min(t0, t1));
      end = std::min(end, std::max(t0, t1));
    }
  }
  if (!(begin < end)) return false;
  // Closeness about `begin`.
  const dvec3 q = p + begin * d;
  out = {begin, end, e.strength, most, {1 - glm::dot(q, q), -2 * glm::dot(q, d), -a}};
  return true;
}

class BlobSurface final : public ScannedShape<BlobSurface> {
 public:
  BlobSurface(const Blob& blob, const Transform& to_world) : threshold_(blob.threshold), mixes_(blob.mixes_textures()) {
    for (std::uint32_t i = 0; i < blob.components.size(); ++i) add_component(blob.components[i], i, to_world);
    const Aabb box = bounds();
    if (!box.empty()) nearest_ = kNearest * std::min(1.0, std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z}));
    constexpr std::size_t kFewest = 50;  // below, a tree costs more than it saves
    if (elements_.size() < kFewest) {
      std::vector<BoundingBalls::Ball> balls;
      for (const Element& element : elements_) balls.push_back(ball_around(element));
      balls_ = BoundingBalls(balls);
      return;
    }
    std::vector<Aabb> boxes;
    for (const Element& element : elements_) boxes.push_back(element_box(element));
    tree_ = Bvh(boxes);
  }

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    range.lo = std::max(range.lo, nearest_);
    thread_local std::vector<Stretch> room_for_stretches;
    thread_local std::vector<double> room_for_ends;
    if (room_for_stretches.size() < elements_.size()) room_for_stretches.resize(elements_.size());
    const BlobRay blob_ray(ray);
    double most = 0;
    Stretch* const first = room_for_stretches.data();
    Stretch* next = first;
    for_elements_near(ray, range, [&](const Element& element) {
      if (element.radius > 0 ? !cross_ball(element, blob_ray, range, *next) : !cross_element(element, ray, range, *next)) return;
      most += next->most;
      ++next;
    });
    if (next == first || is_too_little(most)) return;
    const std::span<Stretch> stretches(first, next);
    if (room_for_ends.size() < 2 * elements_.size()) room_for_ends.resize(2 * elements_.size());
    const std::span<double> ends(room_for_ends.data(), 2 * stretches.size());
    double* end = ends.data();
    for (const Stretch& stretch : stretches) {
      *end++ = stretch.begin;
      *end++ = stretch.end;
    }
    std::sort(ends.begin(), ends.end());
    std::sort(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
    double last = -1;
    std::size_t started = 0;  // stretches before this one have begun
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const double lo = ends[i];
      const double hi = ends[i + 1];
      if (!(hi > lo)) continue;
      while (started < stretches.size() && stretches[started].begin <= lo) ++started;
      const std::span<const Stretch> begun = stretches.first(started);
      if (is_too_little(most_density_of(begun, lo))) continue;
      const std::array<double, 5> c = density_along(begun, lo);
      const bool enough = walk_roots<depth_matters<Sink>()>(c, {0, hi - lo}, [&](double root) {
        const double t = lo + root;
        if (t <= last) return false;  // a root at a joint belongs to both sides
        last = t;
        return t > nearest_ && sink(t, 0);
      });
      if (enough) return;
    }
  }

  Aabb bounds() const override {
    Aabb box;
    for (const Element& e : elements_)
      if (e.strength > 0) box.join(element_box(e));
    return box;
  }
  bool inside(const dvec3& point) const override {
    double density = 0;
    for_elements_at(point, [&](const Element& e) { density += density_at(e, point); });
    return density > threshold_ - kInsideTolerance;
  }
  dvec3 normal(const ShapeHit&, const dvec3& point) const override {
    dvec3 sum(0);
    for_elements_at(point, [&](const Element& e) {
      const dvec3 local = e.to_world.inverse_point(point);
      const double closeness = e.closeness(local);
      if (closeness > 0) sum += 2 * e.strength * closeness * e.to_world.normal(e.radial(local));
    });
    const double length = glm::length(sum);
    return length > 0 ? sum / length : dvec3(1, 0, 0);
  }
  void textures(const ShapeHit& hit, const dvec3& point, std::vector<TextureWeight>& out) const override {
    if (!mixes_) return Shape::textures(hit, point, out);
    const std::size_t first = out.size();
    double total = 0;
    for_elements_at(point, [&](const Element& e) {
      const double density = std::abs(density_at(e, point));
      if (density == 0) return;
      total += density;
      const auto same = std::find_if(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
                                     [&](const TextureWeight& w) { return w.index == e.component; });
      if (same != out.end()) {
        same->weight += static_cast<float>(density);
      } else {
        out.push_back({e.component, static_cast<float>(density)});
      }
    });
    std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
              [](const TextureWeight& a, const TextureWeight& b) { return a.index < b.index; });
    for (std::size_t i = first; i < out.size(); ++i) out[i].weight /= static_cast<float>(total);
  }

 private:
  static Aabb element_box(const Element& e) {
    if (e.piece == Piece::kSide) {
      Aabb box = circle_box(e.to_world, 0, 1);
      box.join(circle_box(e.to_world, 1, 1));
      return box;
    }
    dvec3 reach;
    for (int axis = 0; axis < 3; ++axis)
      reach[axis] = glm::length(dvec3(e.to_world.linear[0][axis], e.to_world.linear[1][axis], e.to_world.linear[2][axis]));
    return {e.to_world.translation - reach, e.to_world.translation + reach};
  }

  static BoundingBalls::Ball ball_around(const Element& e) {
    if (e.piece == Piece::kSide) {
      const Aabb box = element_box(e);
      return {box.center(), 0.5 * glm::length(box.hi - box.lo)};
    }
    // The longest axis of the ellipsoid: no eigenvalue of AᵀA exceeds the sum of a row.
    const dmat3& axes = e.to_world.linear;
    double square = 0;
    for (int i = 0; i < 3; ++i) {
      double row = 0;
      for (int k = 0; k < 3; ++k) row += std::abs(glm::dot(axes[i], axes[k]));
      square = std::max(square, row);
    }
    return {e.to_world.translation, std::sqrt(square)};
  }

  // Always in the same order for the same ray or point, so that sums of densities round the same way.
  template <class Visit>
  void for_elements_near(const Ray& ray, Interval range, Visit&& visit) const {
    if (tree_.empty()) return balls_.for_each_near(ray, [&](std::size_t i) { visit(elements_[i]); });
    std::uint64_t box_tests = 0;
    const auto order = tree_.order();
    tree_.traverse(ray, range, box_tests, [&](std::uint32_t first, std::uint32_t count, double&) {
      for (std::uint32_t i = first; i < first + count; ++i) visit(elements_[order[i]]);
      return false;
    });
  }
  template <class Visit>
  void for_elements_at(const dvec3& point, Visit&& visit) const {
    if (tree_.empty()) return balls_.for_each_at(point, [&](std::size_t i) { visit(elements_[i]); });
    for_elements_near({point, {0, 0, 1}}, {0, 0}, visit);
  }

  void add_component(const BlobComponent& component, std::uint32_t index, const Transform& blob_to_world) {
    if (component.radius == 0 || component.strength == 0) return;
    const double r = std::abs(component.radius);
    const Transform to_world = component.transform.then(blob_to_world);
    const auto add = [&](Piece piece, const Transform& frame) {
      elements_.push_back({piece, index, component.strength, to_world.identity() ? frame : frame.then(to_world)});
      if (piece == Piece::kBall) find_radius(elements_.back());
    };
    if (component.kind == BlobComponent::Kind::kSphere) {
      add(Piece::kBall, Transform::scale(dvec3(r)).then(Transform::translate(component.center)));
      return;
    }
    const dvec3 axis = component.apex - component.center;
    add(Piece::kSide, axis_frame(component.center, axis, r));
    const dvec3 as_long_as_wide = r * glm::normalize(axis);
    add(Piece::kBaseBall, axis_frame(component.center, as_long_as_wide, r));
    add(Piece::kApexBall, axis_frame(component.apex, as_long_as_wide, r));
  }

  static void find_radius(Element& e) {
    constexpr double kRound = 1e-12;
    const dmat3& axes = e.to_world.linear;
    const double square = glm::dot(axes[0], axes[0]);
    for (int i = 0; i < 3; ++i)
      for (int k = i; k < 3; ++k)
        if (!(std::abs(glm::dot(axes[i], axes[k]) - (i == k ? square : 0)) <= kRound * square)) return;
    e.radius = std::sqrt(square);
    e.reciprocal_square = 1 / square;
  }

  // Whether a density cannot reach the threshold, with what rounding may do to it.
  bool is_too_little(double most) const { return most < threshold_ * (1 - 1e-9); }
  static double most_density_of(std::span<const Stretch> begun, double lo) {
    double most = 0;
    for (const Stretch& s : begun)
      if (s.end > lo) most += s.most;
    return most;
  }

  static double density_at(const Element& e, const dvec3& point) {
    const double closeness = e.closeness(e.to_world.inverse_point(point));
    return closeness > 0 ? e.strength * closeness * closeness : 0;
  }

  // The sum of the densities just behind the depth `lo`, less the threshold, about `lo`.
  std::array<double, 5> density_along(std::span<const Stretch> begun, double lo) const {
    std::array<double, 5> sum{-threshold_, 0, 0, 0, 0};
    for (const Stretch& s : begun) {
      if (!(s.end > lo)) continue;
      const double shift = lo - s.begin;
      const double q0 = (s.c[2] * shift + s.c[1]) * shift + s.c[0];
      const double q1 = 2 * s.c[2] * shift + s.c[1];
      const double q2 = s.c[2];
      sum[0] += s.strength * q0 * q0;
      sum[1] += s.strength * 2 * q0 * q1;
      sum[2] += s.strength * (q1 * q1 + 2 * q0 * q2);
      sum[3] += s.strength * 2 * q1 * q2;
      sum[4] += s.strength * q2 * q2;
    }
    return sum;
  }

  double threshold_;
  double nearest_ = kNearest;
  bool mixes_;
  std::vector<Element> elements_;
  BoundingBalls balls_;
  Bvh tree_;  // empty for few elements
};

}  // namespace

bool Blob::mixes_textures() const {
  return std::ranges::any_of(components, [](const BlobComponent& c) { return c.texture != nullptr; });
}

std::unique_ptr<Shape> build(const Blob& blob, const Transform& to_world, BuildContext&) {
  return std::make_unique<BlobSurface>(blob, to_world);
}

}  // namespace lute
