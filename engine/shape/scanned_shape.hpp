// The three ray queries of a shape, all made from one: a shape that derives from ScannedShape<Self> has a member
//
//   template <class Sink> void scan(const Ray& ray, Interval range, Sink&& sink) const;
//
// which hands every hit to `sink(t, part)` or `sink(t, part, data)`, in the order in which ties are decided (the last of equal
// depths wins). It need not test `range` itself, but may use it to give up early. A sink returns true when it needs no hits farther
// away than this one: a shape that finds its hits in ascending order may stop then. Nothing is allocated or virtual inside.
#pragma once

#include "engine/shape/shape.hpp"

namespace lute {

template <class Self>
class ScannedShape : public Shape {
 public:
  void hits(const Ray& ray, Interval range, ShapeHits& out) const final {
    self().scan(ray, range, [&](double t, std::uint32_t part, const std::array<double, 3>& data = {}) {
      if (range.contains(t)) out.push_back({t, part, data});
      return false;
    });
  }

  bool nearest(const Ray& ray, Interval range, ShapeHit& hit) const final {
    bool found = false;
    self().scan(ray, range, [&](double t, std::uint32_t part, const std::array<double, 3>& data = {}) {
      if (!range.contains(t)) return false;  // for NaN too
      hit = {t, part, data};
      range.hi = t;  // a later hit at the same depth still counts
      found = true;
      return true;
    });
    return found;
  }

  bool any(const Ray& ray, Interval range) const final {
    bool found = false;
    self().scan(ray, range, [&](double t, std::uint32_t, const std::array<double, 3>& = {}) {
      found |= range.contains(t);
      return found;
    });
    return found;
  }

 private:
  const Self& self() const { return static_cast<const Self&>(*this); }
};

}  // namespace lute
