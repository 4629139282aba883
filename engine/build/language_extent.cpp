#include "engine/build/language_extent.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/shape/axis_frame.hpp"
#include "engine/shape/glyph_outline.hpp"
#include "engine/shape/quadric_bounds.hpp"

namespace lute {

namespace {

using TightBox = std::function<Aabb(const Object&)>;

constexpr double kUnbounded = 1e10;  // as far as a box reaches
constexpr double kLargest = 1e6;     // of sides that a union's box may have

Aabb everything() { return {dvec3(-kUnbounded), dvec3(kUnbounded)}; }

// Boxes are kept in single precision, as a corner and lengths.
Aabb stored(const Aabb& box) {
  if (box.empty() || !box.is_finite()) return everything();
  Aabb result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto lo = static_cast<float>(std::clamp(box.lo[axis], -kUnbounded, kUnbounded));
    const auto length = static_cast<float>(std::clamp(box.hi[axis], -kUnbounded, kUnbounded) - box.lo[axis]);
    result.lo[axis] = static_cast<double>(lo);
    result.hi[axis] = static_cast<double>(lo + length);
  }
  return result;
}

bool infinite(const Aabb& box) {
  for (int axis = 0; axis < 3; ++axis) {
    if (box.hi[axis] - box.lo[axis] > kLargest) return true;
  }
  return false;
}

Aabb moved(const Aabb& box, const Transform& transform) {
  if (transform.identity()) return box;
  return infinite(box) ? everything() : stored(transform.box(box));
}

// Frame of a shape that is round about `axis`, as POV-Ray turns it, which shows in a box around its corners.
Transform round_frame(const dvec3& base, const dvec3& axis) {
  const dmat3 turn = turn_z_to(axis / glm::length(axis));
  Transform frame;
  frame.linear = turn;
  frame.translation = base;
  frame.inverse_linear = glm::transpose(turn);
  frame.inverse_translation = -(frame.inverse_linear * base);
  frame.kinds = Transform::kMatrix;
  return frame;
}

Aabb round_box(const dvec3& base, const dvec3& axis, double radius, double below, double above, const Transform& transform) {
  const double r = std::abs(radius);
  return stored(round_frame(base, axis).then(transform).box({{-r, -r, below}, {r, r, above}}));
}

std::optional<Aabb> own_rule(const Cylinder& s, const Transform& transform) {
  const dvec3 axis = s.base - s.cap;
  const double length = glm::length(axis);
  if (length == 0) return std::nullopt;
  return round_box(s.cap, axis, s.radius, 0, length, transform);
}
std::optional<Aabb> own_rule(const Cone& s, const Transform& transform) {
  const bool base_is_wide = std::abs(s.base_radius) >= std::abs(s.cap_radius);
  const dvec3 narrow = base_is_wide ? s.cap : s.base, wide = base_is_wide ? s.base : s.cap;
  const double length = glm::length(wide - narrow);
  if (length == 0) return std::nullopt;
  return round_box(narrow, wide - narrow, base_is_wide ? s.base_radius : s.cap_radius, 0, length, transform);
}
std::optional<Aabb> own_rule(const Disc& s, const Transform& transform) {
  constexpr double kHalfThickness = 1e-3;
  if (glm::length(s.normal) == 0) return std::nullopt;
  return round_box(s.center, s.normal, s.radius, -kHalfThickness, kHalfThickness, transform);
}

bool stays_a_sphere(const Transform& transform) {
  return (transform.kinds & ~(Transform::kTranslate | Transform::kRotate | Transform::kUniformScale)) == 0;
}

// A cube around a point, as wide as the widest side of the box around a moved cube: POV-Ray bounds the balls of a blob so.
Aabb moved_cube(const dvec3& center, double half_side, const dmat3& linear) {
  const dmat3 rows = glm::transpose(linear);
  double widest = 0;
  for (int row = 0; row < 3; ++row) widest = std::max(widest, std::abs(rows[row].x) + std::abs(rows[row].y) + std::abs(rows[row].z));
  return {center - half_side * widest, center + half_side * widest};
}

// A cylinder is a ball around its middle and one at each end; what takes density away has no part in the box.
std::optional<Aabb> own_rule(const Blob& s, const Transform& transform) {
  Aabb box;
  for (const BlobComponent& component : s.components) {
    if (component.strength <= 0) continue;
    const Transform& own = component.transform;
    if (component.kind == BlobComponent::Kind::kSphere) {
      box.join(moved_cube(own.point(component.center), component.radius, own.linear));
      continue;
    }
    const dvec3 axis = component.apex - component.center;
    const double length = glm::length(axis);
    const dmat3 linear = own.linear * turn_z_to(axis / length);
    const dvec3 middle = own.point(0.5 * (component.center + component.apex));
    box.join(moved_cube(middle, std::hypot(component.radius, 0.5 * length), linear));
    box.join(moved_cube(own.point(component.center), component.radius, linear));
    box.join(moved_cube(own.point(component.apex), component.radius, linear));
  }
  if (box.empty()) return std::nullopt;
  return moved(stored(box), transform);
}

std::optional<Aabb> own_rule(const Polygon& s, const Transform& transform) {
  constexpr double kThinnest = 1e-3;  // a thinner side is made wider by this at both ends
  Aabb box;
  for (const dvec3& point : s.points) box.join(transform.point(point));
  for (int axis = 0; axis < 3; ++axis) {
    if (box.hi[axis] - box.lo[axis] >= kThinnest) continue;
    box.lo[axis] -= kThinnest;
    box.hi[axis] += kThinnest;
  }
  return stored(box);
}

// Around all balls, also those that only steer a spline; a cubic spline may leave them, by no more than a radius as it is assumed.
std::optional<Aabb> own_rule(const SphereSweep& s, const Transform& transform) {
  const double reach = s.spline == SphereSweep::Spline::kCubic ? 2 : 1;
  const bool moves_balls = stays_a_sphere(transform);
  const double scale = moves_balls ? std::abs(std::cbrt(glm::determinant(transform.linear))) : 1;
  Aabb box;
  for (const SphereSweep::Ball& ball : s.balls) {
    const dvec3 center = moves_balls ? transform.point(ball.center) : ball.center;
    const double radius = reach * ball.radius * scale;
    box.lo = glm::min(box.lo, center - radius);
    box.hi = glm::max(box.hi, center + radius);
  }
  return moves_balls ? stored(box) : moved(stored(box), transform);
}

// Around the control points, which the surface does not reach.
std::optional<Aabb> own_rule(const BicubicPatch& s, const Transform& transform) {
  Aabb box;
  for (const auto& row : s.points) {
    for (const dvec3& point : row) box.join(transform.point(point));
  }
  return stored(box);
}

std::optional<Aabb> own_rule(const JuliaFractal& s, const Transform& transform) {
  const double radius = search_radius(s);
  return moved(stored({dvec3(-radius), dvec3(radius)}), transform);
}

// Each character is an object of its own, with the box that its font states; that of a blank is a point.
std::optional<Aabb> own_rule(const Text& s, const Transform& transform) {
  constexpr double kMargin = 1e-6;  // in front and behind
  const Transform turned = Transform::rotate(dvec3(0.001));  // as every text is
  Aabb box;
  for (const GlyphOutline& glyph : lay_out_text(*s.font, s.string, dvec2(s.offset.x, s.offset.y), s.unicode_first)) {
    Aabb own;
    own.join(dvec3(glyph.stated_lo, -kMargin));
    own.join(dvec3(glyph.stated_hi, s.depth + kMargin));
    box.join(stored(own));
  }
  return moved(stored(turned.box(box)), transform);
}

// Only what is an ellipsoid along the axes as it is declared has a box, whichever side of it is inside.
std::optional<Aabb> own_rule(const Quadric& s, const Transform& transform) {
  if (s.mixed != dvec3(0)) return everything();
  Quadric positive = s;
  if (s.squares.x < 0) positive = {-s.squares, -s.mixed, -s.linear, -s.constant};
  return moved(stored(ellipsoid_bounds(positive, Transform())), transform);
}

template <class S>
std::optional<Aabb> own_rule(const S&, const Transform&) {
  return std::nullopt;
}

// Moved with their numbers, not with a matrix beside them; or without a box.
template <class S>
constexpr bool kMovesItsNumbers = std::is_same_v<S, Triangle> || std::is_same_v<S, SmoothTriangle> ||
                                  std::is_same_v<S, Plane> || std::is_same_v<S, Poly>;

Aabb shape_box(const Object& object, const AnyShape& shape, const TightBox& tight_box) {
  Object bare;
  bare.geometry = object.geometry;
  return shape.visit(
      [&]<class S>(const S& s) {
        if (const auto box = own_rule(s, object.transform)) return *box;
        if (kMovesItsNumbers<S> || (std::is_same_v<S, Sphere> && stays_a_sphere(object.transform))) {
          bare.transform = object.transform;
          return stored(tight_box(bare));
        }
        return moved(stored(tight_box(bare)), object.transform);
      });
}

// The half space of a plane that is parallel to two axes, as a box: the only planes that bound an intersection.
std::optional<Aabb> half_space(const Object& object, bool inverted) {
  const auto* plane = object.shape_if<Plane>();
  if (plane == nullptr) return std::nullopt;
  const dvec3 unit = plane->normal / glm::length(plane->normal);
  const dvec3 normal = glm::normalize(object.transform->normal(unit));
  const double distance = glm::dot(normal, object.transform->point(unit * plane->distance));
  constexpr double kEpsilon = 1e-10;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(normal[axis]) < 1 - kEpsilon) continue;
    Aabb box = everything();
    ((normal[axis] > 0) != inverted ? box.hi : box.lo)[axis] = distance * normal[axis];
    return box;
  }
  return std::nullopt;
}

// What a region leaves of a quadric along the axes that is round, or tapers, about one of them.
Aabb within(QuadraticForm form, const Aabb& region) {
  constexpr double kRounded = 1e-9;
  dvec3 squares(form.s[0][0], form.s[1][1], form.s[2][2]);
  const double zero = kRounded * std::max({std::abs(squares.x), std::abs(squares.y), std::abs(squares.z)});
  if (std::max({std::abs(form.s[0][1]), std::abs(form.s[0][2]), std::abs(form.s[1][2])}) > zero) return region;
  if ((squares.x < -zero) + (squares.y < -zero) + (squares.z < -zero) >= 2) {  // whichever side is inside
    form = {-form.s, -form.v, -form.c};
    squares = -squares;
  }
  int rising = 0, falling = 0;
  double center = form.c;  // the form there
  std::optional<int> vertex_axis;
  for (int axis = 0; axis < 3; ++axis) {
    rising += squares[axis] > zero ? 1 : 0;
    falling += squares[axis] < -zero ? 1 : 0;
    if (std::abs(squares[axis]) > zero) center -= form.v[axis] * form.v[axis] / squares[axis];
    else if (std::abs(form.v[axis]) > zero) vertex_axis = axis;
  }
  if (rising < 2 || (!vertex_axis && center > zero)) return region;
  if (falling > 0 && center < -zero) form.c += -1 - center;  // a hyperboloid is bounded as if its constant were -1
  Aabb box = region;
  if (vertex_axis) {
    const double slope = form.v[*vertex_axis], vertex = std::abs(center) > zero ? -0.5 * center / slope : 0;
    double& end = slope > 0 ? box.hi[*vertex_axis] : box.lo[*vertex_axis];
    end = slope > 0 ? std::min(end, vertex) : std::max(end, vertex);
  }
  return bounds_within(form, 0, box);
}

QuadraticForm moved(const QuadraticForm& f, const Transform& transform) {
  const dmat3& m = transform.inverse_linear;
  const dvec3& t = transform.inverse_translation;
  const dmat3 back = glm::transpose(m);
  return {back * f.s * m, back * (f.s * t + f.v), glm::dot(t, f.s * t) + 2 * glm::dot(f.v, t) + f.c};
}

Aabb within(const Quadric& quadric, const Transform& transform, const Aabb& region) {
  return region.empty() ? region : within(moved(quadratic_form(quadric), transform), region);
}

Aabb csg_box(const Csg& csg, const TightBox& tight_box) {
  if (csg.operation == CsgOperation::kUnion || csg.operation == CsgOperation::kMerge || csg.operation == CsgOperation::kLightGroup) {
    Aabb box;
    for (const ObjectPtr& child : csg.children) {
      if (child->light() == nullptr) box.join(language_extent(*child, tight_box));
    }
    return stored(box);
  }
  Aabb box = everything();
  std::vector<const Object*> quadrics;  // are bounded within the others
  for (std::size_t i = 0; i < csg.children.size(); ++i) {
    const Object& child = *csg.children[i];
    const bool inverted = child.inverse != (csg.operation == CsgOperation::kDifference && i > 0);
    if (const auto half = half_space(child, inverted)) box = box.intersection(*half);
    else if (inverted) continue;
    else if (child.shape_if<Quadric>() != nullptr) quadrics.push_back(&child);
    else box = box.intersection(language_extent(child, tight_box));
  }
  for (const Object* child : quadrics) box = within(*child->shape_if<Quadric>(), *child->transform, box);
  return infinite(box) ? everything() : stored(box);
}

double volume(const Aabb& box) {
  const dvec3 side = box.hi - box.lo;
  return side.x * side.y * side.z;
}

// The boxes of what bounds or clips an object take the place of its own when they are smaller; a quadric is bounded within them.
Aabb limited(const Aabb& box, const Object& object, const std::vector<ObjectPtr>& limits, const TightBox& tight_box) {
  Aabb common = everything();
  for (const ObjectPtr& limit : limits) {
    if (const auto half = half_space(*limit, limit->inverse)) common = common.intersection(*half);
    else if (!limit->inverse) common = common.intersection(language_extent(*limit, tight_box));
  }
  const auto* quadric = limits.empty() ? nullptr : object.shape_if<Quadric>();
  const bool turned = (object.transform->kinds & ~(Transform::kTranslate | Transform::kScale | Transform::kUniformScale)) != 0;
  if (quadric != nullptr && (infinite(box) || !turned)) common = within(*quadric, *object.transform, common);
  if (quadric != nullptr && (common.empty() || infinite(common))) return box;
  return volume(common) < volume(box) ? stored(common) : box;
}

}  // namespace

Aabb language_extent(const Object& object, const TightBox& tight_box) {
  Aabb box;
  if (const Csg* csg = object.csg()) {
    box = object.inverse ? tight_box(object) : moved(csg_box(*csg, tight_box), object.transform);
  } else if (const AnyShape* shape = object.shape()) {
    box = shape_box(object, *shape, tight_box);
  } else {
    return everything();
  }
  box = limited(box, object, object.extras->bounded_by, tight_box);
  return limited(box, object, object.extras->clipped_by, tight_box);
}

}  // namespace lute
