#include "engine/shape/empty_shape.hpp"

namespace lute {

namespace {

class EmptyShape final : public Shape {
 public:
  explicit EmptyShape(bool patch) : patch_(patch) {}
  Aabb bounds() const override { return {}; }
  void hits(const Ray&, Interval, ShapeHits&) const override {}
  bool nearest(const Ray&, Interval, ShapeHit&) const override { return false; }
  bool any(const Ray&, Interval) const override { return false; }
  bool inside(const dvec3&) const override { return false; }
  bool is_patch() const override { return patch_; }
  dvec3 normal(const ShapeHit&, const dvec3&) const override { return {1, 0, 0}; }

 private:
  bool patch_;
};

}  // namespace

std::unique_ptr<Shape> build_empty_shape(bool patch) { return std::make_unique<EmptyShape>(patch); }

}  // namespace lute
