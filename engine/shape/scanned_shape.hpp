// The three ray queries of a shape, all made from one: a shape that derives from ScannedShape<Self> has a member
//
//   template <class Sink> void scan(const Ray& ray, Interval range, Sink&& sink) const;
//
// which hands every hit to `sink(t, part)` or `sink(t, part, data)`, in the order in which ties are decided (the last of equal
// depths wins). It need not test `range` itself, but may use it to give up early. A sink returns true when it needs no hits farther
// away than this one: a shape that finds its hits in ascending order may stop then. Nothing is allocated or virtual inside.
#pragma once

#include <type_traits>

#include "engine/shape/shape.hpp"

namespace lute {

// The sink of `any`: one hit in range is enough, wherever it is.
struct AnyHit {
  static constexpr bool kDepthMatters = false;

  Interval range;
  bool found = false;

  bool operator()(double t, std::uint32_t, const std::array<double, 3>& = {}) {
    found |= range.contains(t);
    return found;
  }
};

// Whether a sink looks at the depth of a hit. Where it does not, a scan that knows of a hit within the range need not say where it is, and ends
// when the sink has returned true.
template <class Sink>
constexpr bool depth_matters() {
  if constexpr (requires { std::remove_cvref_t<Sink>::kDepthMatters; }) {
    return std::remove_cvref_t<Sink>::kDepthMatters;
  } else {
    return true;
  }
}

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
    AnyHit sink{range};
    self().scan(ray, range, sink);
    return sink.found;
  }

 private:
  const Self& self() const { return static_cast<const Self&>(*this); }
};

}  // namespace lute
