#include "engine/shape/isosurface.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "engine/function/enclosure.hpp"
#include "engine/function/function.hpp"
#include "engine/shape/gradient_remark.hpp"
#include "engine/shape/scanned_shape.hpp"
#include "engine/shape/slope_tree.hpp"

namespace lute {

namespace {

// Where max_gradient is not known to be enough, a part of a ray counts as empty only if interval arithmetic proves it: too small a
// max_gradient makes no holes, it costs time. Functions without enclosure (noise, patterns, pigments) have nothing but
// max_gradient.

// What copies of an isosurface share: what is proven of its function, and the steepest slope that rays have seen.
class SharedSlopes {
 public:
  SharedSlopes(std::shared_ptr<const Function> function, const Aabb& box, double max_gradient)
      : tree(std::move(function), box), box_(box), max_gradient_(max_gradient) {}

  SlopeTree tree;

  bool is_of(const Aabb& box, double max_gradient) const {
    return box.lo == box_.lo && box.hi == box_.hi && max_gradient == max_gradient_;
  }
  void note(double slope) const {
    double known = steepest_.load(std::memory_order_relaxed);
    while (slope > known && !steepest_.compare_exchange_weak(known, slope, std::memory_order_relaxed)) {
    }
  }
  double steepest_seen() const { return steepest_.load(std::memory_order_relaxed); }

 private:
  Aabb box_;
  double max_gradient_;
  mutable std::atomic<double> steepest_{0};
};

// The slopes of all isosurfaces of one function.
class SlopesOfFunction {
 public:
  // `first`: no earlier isosurface has asked for the same.
  std::shared_ptr<const SharedSlopes> of(const Isosurface& iso, bool& first) const {
    const Aabb box = iso.container.box();
    first = false;
    for (const auto& slopes : known_)
      if (slopes->is_of(box, iso.max_gradient)) return slopes;
    first = true;
    known_.push_back(std::make_shared<const SharedSlopes>(iso.function, box, iso.max_gradient));
    return known_.back();
  }

 private:
  mutable std::vector<std::shared_ptr<const SharedSlopes>> known_;  // grows while the scene is built, by one thread
};

Interval hull(const Interval& a, const Interval& b) { return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)}; }

// Whether a function certainly stays above zero over a stretch of this width, from its values at both ends, which are not below zero, and
// bounds of its derivative. The margin is far above what rounding can do to the values.
bool stays_positive(double f1, double f2, const Interval& slope, double width) {
  const double down = std::min(slope.lo, 0.0), up = std::max(slope.hi, 0.0);  // at the start, and into the end
  const double margin = 1e-9 * (f1 + f2);
  if (down == 0) return f1 > margin;
  if (up == 0) return f2 > margin;
  return up * (f1 + down * width) - down * f2 > margin * (up - down);  // the lowest value, times up - down
}

// Parts: the surface, then the faces of the container.
enum Part : std::uint32_t { kSurface, kFirstFace };

class ImplicitSurface final : public ScannedShape<ImplicitSurface> {
 public:
  ImplicitSurface(const Isosurface& iso, const Transform& to_world, BuildContext& context)
      : iso_(iso), accuracy_(depth_accuracy(iso.accuracy, iso.container, to_world)), to_world_(to_world) {
    const void* key = iso.function.get();
    auto known = std::static_pointer_cast<const SlopesOfFunction>(context.find_shared(key));
    if (!known) context.store_shared(key, known = std::make_shared<const SlopesOfFunction>());
    slopes_ = known->of(iso, remarks_);
  }

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    const Ray local = to_world_.inverse_ray(ray);
    Container::Passage passage;
    if (!iso_.container.cross(local, passage) || passage.depths.hi < 0) return;
    const double accuracy = accuracy_;
    double begin = std::max(0.0, passage.depths.lo);
    const double end = passage.depths.hi;
    thread_local std::vector<SlopeTree::Piece> pieces;
    pieces.clear();
    if (doubts_max_gradient()) {
      slopes_->tree.along(local, {begin, end}, pieces);
      if (std::ranges::all_of(pieces, [&](const auto& p) { return p.value.lo > iso_.threshold; })) return;
    }
    Search search(*this, local, pieces, range.hi);
    if constexpr (!depth_matters<Sink>()) {
      if (slopes_->tree.knows_function() && !iso_.evaluate) search.anywhere = range;
    }
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
        if (search.at_end(end) < 0 && sink(end, kFirstFace + passage.leave) && !depth_matters<Sink>()) return;
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
    if (hit.part >= kFirstFace && iso_.container.has_normal(hit.part - kFirstFace)) {
      n = iso_.container.normal(hit.part - kFirstFace, p);
    } else {
      const double step = iso_.accuracy;
      const double here = value(p);
      n = {value(p + dvec3(step, 0, 0)) - here, value(p + dvec3(0, step, 0)) - here, value(p + dvec3(0, 0, step)) - here};
      if (n == dvec3(0)) n = {1, 0, 0};
    }
    return glm::normalize(to_world_.normal(n));
  }
  // Copies beside the first have nothing to say.
  GradientRemark remark() const {
    if (!remarks_ || iso_.evaluate) return {};
    return {slopes_->steepest_seen(), iso_.max_gradient, slopes_->tree.knows_function()};
  }

 private:
  // Root search along one ray; `gradient` grows under `evaluate`.
  struct Search {
    const ImplicitSurface& surface;
    const Ray& ray;
    double length;  // of the direction
    double gradient;
    double sign = 1;
    double steepest = 0;  // seen, by depth
    double farthest;      // no root beyond is asked for
    Interval anywhere{0, -1};  // where any depth will do for a root; only if max_gradient is proven or not relied on
    std::vector<SlopeTree::Piece>& pieces;  // none: max_gradient is enough everywhere, or nothing else is known

    Search(const ImplicitSurface& s, const Ray& r, std::vector<SlopeTree::Piece>& of_ray, double far)
        : surface(s), ray(r), length(glm::length(r.direction)), gradient(s.iso_.max_gradient), farthest(far), pieces(of_ray) {}
    Search(const Search&) = delete;
    Search& operator=(const Search&) = delete;
    ~Search() { surface.slopes_->note(steepest / length); }

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
      return bisect(begin, f, sign * at_end(end), end - begin, gradient * length * (end - begin),
                    {0, pieces.empty() ? 0 : pieces.size() - 1}, root);
    }

    // Pieces of the ray, by index: those that a stretch lies in.
    struct Pieces {
      std::size_t first = 0, last = 0;
    };
    Pieces within(Pieces p, double t1, double t2) const {
      while (p.first < p.last && pieces[p.first].end <= t1) ++p.first;
      while (p.last > p.first && pieces[p.last - 1].end >= t2) --p.last;
      return p;
    }

    const Interval& slope_of(std::size_t piece) const {
      SlopeTree::Piece& p = pieces[piece];
      if (!p.slope_known) SlopeTree::find_slope(ray, p);
      return p.slope;
    }

    bool is_certain(const Interval& value) const {
      return sign > 0 ? value.lo > surface.iso_.threshold : value.hi < surface.iso_.threshold;
    }

    // Whether the stretch certainly meets no surface. `promised`: by max_gradient.
    bool is_empty(Interval depths, double f1, double f2, bool promised, Pieces p) const {
      const auto proves = [&](Interval slope) {
        if (sign < 0) slope = {-slope.hi, -slope.lo};
        return stays_positive(f1, f2, slope, depths.hi - depths.lo);
      };
      const auto certain = [&](std::size_t i) { return is_certain(pieces[i].value); };
      std::size_t i = p.first;
      while (i <= p.last && certain(i)) ++i;
      if (i > p.last) return true;
      Interval slope = slope_of(p.first);
      for (i = p.first; proves(slope); slope = hull(slope, slope_of(i)))
        if (i++ == p.last) return true;
      if (!promised) return false;
      bool bounded = true;
      for (i = p.first; i <= p.last; ++i) {
        if (!certain(i)) SlopeTree::too_wide(pieces[i]);
        bounded = bounded && std::isfinite(slope_of(i).lo);
      }
      if (bounded) return false;
      const Enclosure here = enclosed(depths);
      if (is_certain({here.lo, here.hi}) || proves({here.slope_lo, here.slope_hi})) return true;
      // Where even at a point nothing is known there is only max_gradient.
      const double middle = 0.5 * (depths.lo + depths.hi);
      return !std::isfinite(here.slope_lo) && !std::isfinite(enclosed({middle, middle}).slope_lo);
    }

    Enclosure enclosed(Interval depths) const {
      Enclosure arguments[3], result;
      for (int axis = 0; axis < 3; ++axis) {
        const double d = ray.direction[axis], a = ray.origin[axis] + depths.lo * d, b = ray.origin[axis] + depths.hi * d;
        arguments[axis] = {std::min(a, b), std::max(a, b), d, d};
      }
      return surface.iso_.function->enclose(arguments, &result) ? result : Enclosure::unknown();
    }

    // f1 and f2 are the values at both ends; m bounds how much the function can change between them.
    bool bisect(double t1, double f1, double f2, double width, double m, Pieces p, double& root) {
      if (t1 > farthest) return false;
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
      if (std::isinf(m)) return false;
      if (f1 >= 0 && f2 < 0 && anywhere.lo <= t1 && t1 + width <= anywhere.hi) {  // bisection would find one
        root = t1 + width;
        return true;
      }
      if (std::abs(f2 - f1) > steepest * width) steepest = std::abs(f2 - f1) / width;
      const bool promised = f1 + f2 - m >= 0;
      if (pieces.empty()) {
        if (promised) return false;
      } else if (f1 >= 0 && f2 >= 0) {
        p = within(p, t1, t1 + width);
        if (is_empty({t1, t1 + width}, f1, f2, promised, p)) return false;
      }
      const double half = 0.5 * width;
      const double middle = t1 + half;
      const double f = at(middle);
      return bisect(t1, f1, f, half, 0.5 * m, p, root) || bisect(middle, f, f2, half, 0.5 * m, p, root);
    }
  };

  // `evaluate` may lower it.
  bool doubts_max_gradient() const {
    return slopes_->tree.knows_function() && (iso_.evaluate || !(slopes_->tree.steepest() <= iso_.max_gradient));
  }
  double value(const dvec3& p) const { return iso_.function->at(p) - iso_.threshold; }

  Isosurface iso_;
  double accuracy_;  // along the ray
  Transform to_world_;
  std::shared_ptr<const SharedSlopes> slopes_;
  bool remarks_ = false;  // the first of its copies
};

}  // namespace

std::unique_ptr<Shape> build(const Isosurface& isosurface, const Transform& to_world, BuildContext& context) {
  return std::make_unique<ImplicitSurface>(isosurface, to_world, context);
}

GradientRemark gradient_remark(const Shape& isosurface) { return dynamic_cast<const ImplicitSurface&>(isosurface).remark(); }

}  // namespace lute
