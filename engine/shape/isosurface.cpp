#include "engine/shape/isosurface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/function/function.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

// Parts: the surface, then the faces of the container.
enum Part : std::uint32_t { kSurface, kFirstFace };

class ImplicitSurface final : public ScannedShape<ImplicitSurface> {
 public:
  ImplicitSurface(const Isosurface& iso, const Transform& to_world) : iso_(iso), accuracy_(depth_accuracy(iso.accuracy, iso.container, to_world)), to_world_(to_world) {}

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    const Ray local = to_world_.inverse_ray(ray);
    Container::Passage passage;
    if (!iso_.container.cross(local, passage) || passage.depths.hi < 0) return;
    const double accuracy = accuracy_;
    double begin = std::max(0.0, passage.depths.lo);
    const double end = passage.depths.hi;
    Search search{*this, local, glm::length(local.direction), iso_.max_gradient, 1};
    int count = 0;
    if (!iso_.open) {
      if (begin > accuracy) {
        if (search.at_begin(begin) < 0) {
          if (sink(begin, kFirstFace + passage.enter)) return;
          count = 1;
          search.sign = -1;
        }
      } else {
        if (search.at_begin(begin) < 4 * search.gradient * accuracy) {
          begin = 5 * accuracy;
          if (search.at_begin(begin) < 0) search.sign = -1;
        }
        if (search.at_end(end) < 0) sink(end, kFirstFace + passage.leave);
      }
    }
    if (end - begin < accuracy) return;
    if (begin < accuracy && search.sign > 0 && std::abs(search.at_begin(begin)) < 4 * search.gradient * accuracy) {
      begin = 5 * accuracy;
      if (search.at_begin(begin) < 0) search.sign = -1;
    }
    for (; count < iso_.max_trace && begin <= range.hi; ++count) {
      double root = 0;
      if (!search.first_root(begin, end, root)) return;
      if (sink(root, kSurface)) return;
      begin = root + 5 * accuracy;
      if (end - begin < accuracy) return;
      search.sign = -search.sign;
    }
  }

  Aabb bounds() const override { return to_world_.box(iso_.container.box()); }
  bool inside(const dvec3& point) const override {
    const dvec3 p = to_world_.inverse_point(point);
    return iso_.container.contains(p) && value(p) <= 0;
  }
  dvec3 normal(const ShapeHit& hit, const dvec3& point) const override {
    const dvec3 p = to_world_.inverse_point(point);
    dvec3 n;
    if (hit.part >= kFirstFace) {
      n = iso_.container.normal(hit.part - kFirstFace, p);
    } else {
      const double step = iso_.accuracy;
      const double here = value(p);
      n = {value(p + dvec3(step, 0, 0)) - here, value(p + dvec3(0, step, 0)) - here, value(p + dvec3(0, 0, step)) - here};
      if (n == dvec3(0)) n = {1, 0, 0};
    }
    return glm::normalize(to_world_.normal(n));
  }

 private:
  // Root search along one ray; `gradient` grows under `evaluate`.
  struct Search {
    const ImplicitSurface& surface;
    const Ray& ray;
    double length;  // of the direction
    double gradient;
    double sign;

    struct Known {
      double t = std::numeric_limits<double>::quiet_NaN(), value = 0;
    };
    Known last_begin{}, last_end{};

    double known(Known& last, double t) const {
      if (last.t != t) last = {t, surface.value(ray.at(t))};
      return last.value;
    }

    double at(double t) const { return sign * surface.value(ray.at(t)); }

    // At the ends, without the sign. They are asked for again and again, and the function is dear.
    double at_begin(double t) { return known(last_begin, t); }
    double at_end(double t) { return known(last_end, t); }

    bool first_root(double begin, double end, double& root) {
      double f = sign * at_begin(begin);
      if (surface.iso_.open && f < 0) {
        sign = -sign;
        f = -f;
      }
      if (const auto& e = surface.iso_.evaluate; e && gradient > (*e)[0]) gradient *= (*e)[2];
      return bisect(begin, f, sign * at_end(end), end - begin, gradient * length * (end - begin), root);
    }

    // f1 and f2 are the values at both ends; m bounds how much the function can change between them.
    bool bisect(double t1, double f1, double f2, double width, double m, double& root) {
      // A depth whose grain is coarser than the accuracy, far away, cannot be divided any more.
      if (width < surface.accuracy_ || t1 + 0.5 * width == t1) {
        if (!(f2 < 0)) return false;
        root = t1 + width;
        return true;
      }
      if (const auto& e = surface.iso_.evaluate) {
        const double slope = std::abs(f2 - f1) / (length * width);
        if (gradient < slope * (*e)[1]) {
          gradient = slope * (*e)[1] * (*e)[1];
          m = gradient * length * width;
        }
      }
      if (f1 + f2 - m >= 0 || std::isinf(m)) return false;
      const double half = 0.5 * width;
      const double middle = t1 + half;
      const double f = at(middle);
      return bisect(t1, f1, f, half, 0.5 * m, root) || bisect(middle, f, f2, half, 0.5 * m, root);
    }
  };

  double value(const dvec3& p) const { return iso_.function->at(p) - iso_.threshold; }

  Isosurface iso_;
  double accuracy_;  // along the ray
  Transform to_world_;
};

}  // namespace

std::unique_ptr<Shape> build(const Isosurface& isosurface, const Transform& to_world, BuildContext&) {
  return std::make_unique<ImplicitSurface>(isosurface, to_world);
}

}  // namespace lute
