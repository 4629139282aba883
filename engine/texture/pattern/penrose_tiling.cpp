#include "engine/texture/pattern/penrose_tiling.hpp"

#include <algorithm>
#include <cmath>

namespace lute {
namespace {

const double kPhi = (1 + std::sqrt(5.0)) / 2;
constexpr double kGap = 1e-6;  // keeps the values of neighbouring kinds of tiles apart

double sine(double degrees) { return std::sin(radians(degrees)); }
double cosine(double degrees) { return std::cos(radians(degrees)); }
double tangent(double degrees) { return std::tan(radians(degrees)); }

const double kS18 = sine(18), kC18 = cosine(18), kS36 = sine(36), kC36 = cosine(36), kS72 = sine(72), kC72 = cosine(72);
const double kS108 = sine(108), kC108 = cosine(108), kS144 = sine(144), kC144 = cosine(144), kS162 = sine(162), kC162 = cosine(162);
const double kT18 = tangent(18), kT36 = tangent(36), kT54 = tangent(54), kT72 = tangent(72), kT108 = tangent(108),
             kT126 = tangent(126), kT144 = tangent(144), kT162 = tangent(162);

struct Point {
  double x, z;
};
Point operator*(Point p, double s) { return {p.x * s, p.z * s}; }

Point rotated(Point p, double s, double c) { return {p.x * c - p.z * s, p.z * c + p.x * s}; }
Point by_plus_36(Point p) { return rotated(p, kS36, kC36); }
Point by_minus_36(Point p) { return rotated(p, -kS36, kC36); }
Point by_minus_144(Point p) { return rotated(p, -kS144, kC144); }
Point by_plus_72(Point p) { return rotated(p, kS72, kC72); }
Point by_plus_108(Point p) { return rotated(p, kS108, kC108); }

// Into the sector of 36 degrees beside the x axis: five-fold symmetry with mirrors.
Point folded(Point p) {
  p.z = std::fabs(p.z);
  const double r = std::sqrt(p.x * p.x + p.z * p.z);
  if (!(p.x < r * kC36)) return p;
  const bool twice = p.x < r * kC108;
  const Point q = twice ? by_minus_144(p) : rotated(p, -kS72, kC72);
  return {q.x, std::fabs(q.z)};
}

bool at_center(double x, double z) { return std::sqrt(x * x + z * z) <= kEpsilon; }

// How many times `growth` must be applied to a unit to cover `size`.
int steps_to_cover(double size, double growth) {
  return static_cast<int>(std::max(0.0, std::ceil(std::log(size) / std::log(growth))));
}

// Kites (half kites) and darts; the leaf of either kind is asked for its value.
template <class KiteLeaf, class DartLeaf>
double divide_kite(Point p, const KiteLeaf& kite_leaf, const DartLeaf& dart_leaf) {
  const double d = std::fabs(kS108 * p.x - kC108 * p.z) / kC18;
  const int m = steps_to_cover(d, kPhi * kPhi);
  p = p * std::pow(kPhi, -2 * m);
  if (m % 2 == 1) p = by_minus_36(p);
  bool kite = true;
  for (int depth = 2 * m; depth > 0; --depth) {
    p.z = std::fabs(p.z);
    if (kite) {
      kite = !(p.z < (p.x - 1 / kPhi) * kT144);
      if (kite) p = by_plus_108({p.x - kC36, p.z - kS36});
    } else {
      kite = p.z < (p.x - 1 / kPhi) * kT108;
      p = kite ? by_minus_36(p) : by_minus_144({p.x - 1, p.z});
    }
    p = p * kPhi;
  }
  p.z = std::fabs(p.z);
  return kite ? kite_leaf(p) : dart_leaf(p);
}

double low_half(double d1, double d2) { return std::min(std::max({0.5 - d1 / 2, 0.5 - d2 / 2, 0.0}), 0.5 - kGap); }
double high_half(double d1, double d2) { return std::max({1 - d1 / 2, 1 - d2 / 2, 0.5 + kGap}); }

// The tiles of tiling 25: three kinds of pentagons by their neighbours, two boats, a star, two diamonds.
enum class Node { kP1, kP2Inside, kP2Outside, kP3Inside, kP3Outside, kStar, kBoatInside, kBoatOutside, kDiamondA, kDiamondB };

const double kRadius = 0.5 / kS36, kApothem = 0.5 / kT36;  // of the unit pentagon
const double kI1 = 1 / kPhi, kI2 = 1 / (kPhi * kPhi);

struct Place {
  Node node;
  Point p;
};

Place turned_to_p3(Point rotated_point) { return {Node::kP3Outside, {-rotated_point.x - kC72 * kRadius, rotated_point.z - kS72 * kRadius}}; }

// The child tile that holds the point, in the parent's scale.
Place child_of(Node node, Point p) {
  const double r = kRadius, x = p.x, z = p.z;
  switch (node) {
    case Node::kP1: {
      const Point f = folded(p);
      if (f.z < (f.x - kApothem) * kT54 + 0.5) return {Node::kP2Outside, {f.x - kApothem - kI1 * r * kC72, f.z}};
      return {Node::kStar, by_minus_36(f)};
    }
    case Node::kP2Inside: {
      if (z < (x - kI2 * r) * kT54) return {Node::kP1, {x - r, z}};
      if (z < (x - kI2 * r) * kT162) return {Node::kDiamondA, {-x, z}};
      const Point q = by_plus_108(p);
      return {Node::kP2Inside, {q.x + kI1 * r, q.z}};
    }
    case Node::kP2Outside:
      if (z < (x + r) * kT18) return {Node::kDiamondB, {x + r - kI2 * r, z}};
      return turned_to_p3(by_minus_36(p));
    case Node::kP3Inside:
      if (x > kI2 * r * kC72) return {Node::kP2Inside, {-(x - kI2 * r * kC72 - kI1 * kApothem), z}};
      return {Node::kBoatInside, p};
    case Node::kP3Outside:
      if (x < r * kC108) {
        const Point q = by_minus_144(p);
        return {Node::kP2Outside, {q.x - r, q.z}};
      }
      if (z > (x - kI2 * r) * kT126) return turned_to_p3(by_plus_36(p));
      return {Node::kBoatOutside, p};
    case Node::kStar:
      if (x < kI1 * kApothem) return {Node::kP1, p};
      return {Node::kP3Inside, {-(x - 2 * kI1 * kApothem), z}};
    case Node::kBoatInside:
      if (x > kPhi * r * kC108) return {Node::kP1, {-x, z}};
      return {Node::kP3Inside, {x + r, z}};
    case Node::kBoatOutside: {
      const Point q = by_plus_72(p);
      return {Node::kP3Inside, {q.x + r, q.z}};
    }
    case Node::kDiamondA: return {Node::kP1, p};
    case Node::kDiamondB: return {Node::kP3Inside, p};
  }
  return {node, p};
}

double star_distance(Point p) { return std::fabs(kS162 * (p.x - kPhi * kRadius) - kC162 * p.z); }

double pentagon_leaf(Node node, Point p) {
  const double w = 5.55 / kPhi;
  const auto value = [](int kind, double d) {
    const double low = kind == 1 ? 0 : (kind - 1) / 6.0 + kGap;
    return std::clamp((kind - d) / 6, low, kind / 6.0 - kGap);
  };
  switch (node) {
    case Node::kP1: return value(1, w * std::fabs(folded(p).x - kApothem));
    case Node::kP2Inside:
    case Node::kP2Outside: return value(2, w * std::fabs(folded(p).x - kApothem));
    case Node::kP3Inside:
    case Node::kP3Outside: return value(3, w * std::fabs(folded(p).x - kApothem));
    case Node::kStar: return value(4, w * star_distance(p));
    case Node::kBoatInside:
    case Node::kBoatOutside:
      return value(5, std::min(w * std::fabs(p.x - kI1 * kRadius * kC72), w * star_distance(folded({-p.x, p.z}))));
    case Node::kDiamondA:
    case Node::kDiamondB: return value(6, w * std::fabs(kS18 * (p.x + kI1 * kRadius) - kC18 * p.z));
  }
  return 0;
}

}  // namespace

double penrose_pentagons(double x, double z) {
  if (at_center(x, z)) return 1;
  Point p = folded({x, z});
  const int m = steps_to_cover(2 * kT36 * p.x, std::pow(kPhi, 4));
  p = p * std::pow(kPhi, -4 * m);
  Node node = Node::kP1;
  for (int depth = 4 * m; depth > 0; --depth) {
    p.z = std::fabs(p.z);
    const Place child = child_of(node, p);
    node = child.node;
    p = child.p * kPhi;
  }
  p.z = std::fabs(p.z);
  return pentagon_leaf(node, p);
}

double penrose_kites_and_darts(double x, double z) {
  if (at_center(x, z)) return 1;
  constexpr double q = 4.46;
  return divide_kite(
      folded({x, z}),
      [](Point p) { return low_half(q * std::fabs(kS36 * p.x - kC36 * p.z), q * std::fabs(kS108 * (p.x - 1) - kC108 * p.z)); },
      [](Point p) { return high_half(q * std::fabs(p.z), q * std::fabs(kS144 * (p.x - 1) - kC144 * p.z)); });
}

double penrose_rhombs(double x, double z) {
  if (at_center(x, z)) return 1;
  constexpr double q = 5.55;
  return divide_kite(
      folded({x, z}) * (1 / kPhi),
      [](Point p) {
        const double diagonal = q * std::fabs(kS72 * (p.x - 1 / kPhi) - kC72 * p.z);
        if (p.z < (p.x - 1 / kPhi) * kT72) return high_half(diagonal, q * std::fabs(kS108 * (p.x - 1) - kC108 * p.z));
        return low_half(q * std::fabs(p.z), diagonal);
      },
      [](Point p) { return low_half(q * std::fabs(kS36 * p.x - kC36 * p.z), q * std::fabs(kS144 * (p.x - 1) - kC144 * p.z)); });
}

}  // namespace lute
