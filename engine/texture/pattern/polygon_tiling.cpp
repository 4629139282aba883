#include "engine/texture/pattern/polygon_tiling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <utility>

#include "engine/math/rounding.hpp"

namespace lute {
namespace {

const double kRoot3 = std::sqrt(3.0), kRoot2 = std::sqrt(2.0);
const double kH = kRoot3 / 2;          // height of the unit triangle
const double kI = 1 / (2 * kRoot3);    // its inradius
const double kG = kH + 0.5;

dvec2 direction(double degrees) { return {std::cos(radians(degrees)), std::sin(radians(degrees))}; }
dvec2 away(dvec2 center, double distance, double degrees) { return center + distance * direction(degrees); }

// A polygon by its corners.
struct Polygon {
  std::vector<dvec2> corners;
  int color_class;
};

// Regular, side 1; one edge's outward normal points to `degrees`.
Polygon regular(int color_class, int sides, dvec2 center, double degrees) {
  Polygon polygon{{}, color_class};
  const double radius = 0.5 / std::sin(kPi / sides);
  for (int i = 0; i < sides; ++i) polygon.corners.push_back(away(center, radius, degrees + (i + 0.5) * 360 / sides));
  return polygon;
}

Polygon box(int color_class, double x0, double z0, double x1, double z1) {
  return {{{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}}, color_class};
}

Polygon corners(int color_class, std::initializer_list<dvec2> points) { return {points, color_class}; }

dvec2 middle(const Polygon& polygon) {
  dvec2 sum{0, 0};
  for (const dvec2& c : polygon.corners) sum += c;
  return sum / static_cast<double>(polygon.corners.size());
}

std::vector<TileEdge> edges_of(const Polygon& polygon, double scale) {
  const dvec2 inside = middle(polygon);
  std::vector<TileEdge> edges;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const dvec2 a = polygon.corners[i], b = polygon.corners[(i + 1) % polygon.corners.size()];
    dvec2 outward = glm::normalize(dvec2(b.y - a.y, a.x - b.x));
    if (glm::dot(outward, inside - a) > 0) outward = -outward;
    edges.push_back({outward, glm::dot(outward, a), scale});
  }
  return edges;
}

// What a tiling is made of, as the table of chapter 50 §7 gives it.
struct Recipe {
  int classes;
  double reach;  // distance from an edge over which the value falls to 0
  dvec2 along[2];
  std::vector<Polygon> polygons;
  std::vector<std::pair<int, double>> least, raised;  // class, amount
  bool fill_with_triangles = false;  // what the polygons leave free is tiling 3's grid
};

std::vector<Polygon> basket() {  // tiling 11
  return {box(0, 1, 1, 2, 2), box(1, 1, 0, 3, 1), box(1, 0, 2, 2, 3), box(2, 0, 0, 1, 2), box(2, 2, 1, 3, 3)};
}

std::vector<Polygon> mirrored_basket() {
  std::vector<Polygon> result;
  for (const int sx : {-1, 1})
    for (const int sz : {-1, 1})
      for (Polygon polygon : basket()) {
        for (dvec2& c : polygon.corners) c = {3 + sx * c.x, 3 + sz * c.y};
        result.push_back(polygon);
      }
  return result;
}

// A square framed by trapezia; classes of the square and of the trapezia toward +x, -x, -z, +z.
std::vector<Polygon> framed_square(int square, int right, int left, int down, int up) {
  std::vector<Polygon> result = {box(square, -1, -1, 1, 1), corners(right, {{1, -1}, {1, 1}, {2, 2}, {2, -2}}),
                                 corners(left, {{-1, -1}, {-1, 1}, {-2, 2}, {-2, -2}}),
                                 corners(down, {{-1, -1}, {1, -1}, {2, -2}, {-2, -2}}),
                                 corners(up, {{-1, 1}, {1, 1}, {2, 2}, {-2, 2}})};
  for (Polygon& polygon : result)
    for (dvec2& c : polygon.corners) c = (c + dvec2(2, 2)) / kRoot2;
  return result;
}

// A hexagon with squares around it (classes at 90, 30, -30 degrees) and triangles between them (0, 60).
std::vector<Polygon> rhombitrihexagonal(int hexagon, std::array<int, 3> squares, std::array<int, 2> triangles) {
  const dvec2 c{kG, kG};
  std::vector<Polygon> result{regular(hexagon, 6, c, 90)};
  const double at[3] = {90, 30, -30};
  for (std::size_t i = 0; i < 3; ++i) result.push_back(regular(squares[i], 4, away(c, kG, at[i]), at[i]));
  for (std::size_t i = 0; i < 2; ++i)
    result.push_back(regular(triangles[i], 3, away(c, 1 + 1 / kRoot3, 60.0 * static_cast<double>(i)), 60.0 * static_cast<double>(i)));
  return result;
}

// A dodecagon with squares (classes at 180, 120, 60 degrees) and hexagons.
std::vector<Polygon> dodecagons_squares_hexagons(int dodecagon, std::array<int, 3> squares) {
  const dvec2 d{1.5 + kH, 1 + kRoot3};
  std::vector<Polygon> result{regular(dodecagon, 12, d, 0)};
  const double at[3] = {180, 120, 60};
  for (std::size_t i = 0; i < 3; ++i) result.push_back(regular(squares[i], 4, away(d, 1.5 + kH, at[i]), at[i]));
  for (const double a : {90.0, -90.0}) result.push_back(regular(0, 6, away(d, 1 + kRoot3, a), 90));
  return result;
}

std::vector<Polygon> snub_squares() {  // tiling 21
  const double c = (1 + kRoot3) / 4;
  return {regular(4, 4, {c, c}, 60),       regular(4, 4, {-c, -c}, 60),      regular(5, 4, {-c, c}, 120),
          regular(5, 4, {c, -c}, 120),     regular(0, 3, {kI, 0}, 180),      regular(0, 3, {kG + kI, kG}, 180),
          regular(1, 3, {kG, -kI}, 90),    regular(1, 3, {0, kG - kI}, 90),  regular(2, 3, {-kI, 0}, 0),
          regular(2, 3, {kG - kI, kG}, 0), regular(3, 3, {kG, kI}, -90),     regular(3, 3, {0, kG + kI}, -90)};
}

Recipe recipe(int number) {
  const double h = kH, i = kI, r2 = kRoot2, r3 = kRoot3;
  const dvec2 dodecagon{1 + h, 1 + h};
  const dvec2 hexagon_lattice[2] = {{0, 1 + r3}, {(3 + r3) / 2, (1 + r3) / 2}};
  const double c = r2 / 2 + 0.5;
  switch (number) {
    case 1: return {1, 0.5, {{1, 0}, {0, 1}}, {box(0, 0, 0, 1, 1)}, {}, {}};
    case 2: return {1, h, {{3, 0}, {1.5, h}}, {regular(0, 6, {0.5, h}, 90)}, {}, {}};
    case 3: return {2, i, {{1, 0}, {0.5, h}}, {regular(0, 3, {0.5, i}, -90), regular(1, 3, {1, h - i}, 90)}, {}, {}};
    case 4: return {1, r3 / 4, {{1, 0}, {0.5, h}}, {corners(0, {{0, 0}, {1, 0}, {1.5, h}, {0.5, h}})}, {}, {}};
    case 5:
      return {3, r3 / 4, {{3, 0}, {1.5, h}},
              {corners(0, {{0, 0}, {1, 0}, {1.5, h}, {0.5, h}}), corners(1, {{0, 0}, {0.5, h}, {0, r3}, {-0.5, h}}),
               corners(2, {{0, 0}, {-1, 0}, {-1.5, h}, {-0.5, h}})}, {}, {}};
    case 6: return {2, 0.5, {{1, 1}, {4, 0}}, {box(1, 0, 0, 1, 2), box(0, 1, 0, 3, 1)}, {}, {}};
    case 7: return {2, 0.5, {{1 + r2, 0}, {0, 1 + r2}}, {regular(0, 4, {c, c}, 45), regular(1, 8, {0, 0}, 0)}, {{1, 1e-12}}, {}};
    case 8:
      return {3, i, {{1, 0}, {0.5, 1 + h}},
              {regular(0, 3, {0.5, 1 + i}, -90), regular(1, 3, {1, 1 + h - i}, 90), box(2, 0, 0, 1, 1)}, {}, {{2, 1e-7}}};
    case 9:
      return {3, i, {{2, 0}, {1, r3}},
              {regular(0, 3, {-0.5, i}, -90), regular(1, 3, {-0.5, r3 - i}, 90), regular(2, 6, {0.5, h}, 90)}, {{2, 1e-7}}, {}};
    case 10: return {1, 0.5, {{1, 0}, {0.5, 1}}, {box(0, 0, 0, 1, 1)}, {}, {}};
    case 11: return {3, 0.5, {{3, 0}, {0, 3}}, basket(), {}, {}};
    case 12: return {3, 0.5, {{6, 0}, {0, 6}}, mirrored_basket(), {}, {}};
    case 13: return {3, r2 / 4, {{2 * r2, 0}, {0, 2 * r2}}, framed_square(0, 2, 2, 1, 1), {}, {}};
    case 14: return {5, r2 / 4, {{2 * r2, 0}, {0, 2 * r2}}, framed_square(4, 0, 1, 2, 3), {}, {{4, 1e-6}}};
    case 15: return {2, 0.5, {{2, 1}, {5, 0}}, {box(0, 0, 0, 1, 1), box(1, 1, -1, 3, 1)}, {}, {{1, 2e-8}}};
    case 16:
      return {3, i, {hexagon_lattice[0], hexagon_lattice[1]}, rhombitrihexagonal(2, {0, 0, 0}, {1, 1}), {{2, 1e-7}}, {}};
    case 17:
      return {6, i, {hexagon_lattice[0], hexagon_lattice[1]}, rhombitrihexagonal(5, {0, 1, 2}, {4, 3}), {{5, 1e-6}},
              {{1, 1e-6}, {2, 1e-6}}};
    case 18:
      return {2, 0.5, {{4, 0}, {2, 2}}, {box(1, 0, 0, 1, 2), box(1, 1, 0, 2, 2), box(0, 2, 0, 4, 1), box(0, 2, 1, 4, 2)}, {}, {}};
    case 19: return {3, i, {{2.5, -h}, {2, r3}}, {regular(2, 6, {1, r3}, 90)}, {{2, 1e-6}}, {}, true};
    case 20: return {3, i, {{2.5, h}, {2, -r3}}, {regular(2, 6, {1, r3}, 90)}, {{2, 1e-6}}, {}, true};
    case 21: return {6, i, {{1 + r3, 0}, {0, 1 + r3}}, snub_squares(), {{4, 1e-6}, {5, 1e-6}}, {}};
    case 22:
      return {3, i, {{2 + r3, 0}, {(2 + r3) / 2, (3 + 2 * r3) / 2}},
              {regular(2, 12, dodecagon, 0), regular(0, 3, away(dodecagon, 1 + h + i, 90), -90),
               regular(1, 3, away(dodecagon, 1 + h + i, -90), 90)}, {}, {{2, 1e-7}}};
    case 23:
      return {3, 0.5, {{3 + r3, 0}, {(3 + r3) / 2, (3 + 3 * r3) / 2}}, dodecagons_squares_hexagons(2, {1, 1, 1}), {{2, 1e-6}}, {}};
    default:
      return {5, 0.5, {{3 + r3, 0}, {(3 + r3) / 2, (3 + 3 * r3) / 2}}, dodecagons_squares_hexagons(4, {1, 3, 2}), {{4, 1e-6}}, {}};
  }
}

struct Bounds {
  dvec2 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
  void add(dvec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  bool touches(const Bounds& other) const {
    constexpr double kMargin = 1e-9;
    return low.x <= other.high.x + kMargin && other.low.x <= high.x + kMargin && low.y <= other.high.y + kMargin &&
           other.low.y <= high.y + kMargin;
  }
};

Bounds bounds_of(const Polygon& polygon) {
  Bounds b;
  for (const dvec2& c : polygon.corners) b.add(c);
  return b;
}

// Every translate of the polygons that touches `region`.
std::vector<Polygon> translates(const std::vector<Polygon>& polygons, const dvec2 (&along)[2], const Bounds& region) {
  constexpr int kReach = 6;  // the polygons of the table lie near the origin
  std::vector<Polygon> result;
  for (int a = -kReach; a <= kReach; ++a)
    for (int b = -kReach; b <= kReach; ++b)
      for (Polygon polygon : polygons) {
        for (dvec2& corner : polygon.corners) corner += static_cast<double>(a) * along[0] + static_cast<double>(b) * along[1];
        if (bounds_of(polygon).touches(region)) result.push_back(std::move(polygon));
      }
  return result;
}

bool contains(const Polygon& polygon, dvec2 point) {
  const auto edges = edges_of(polygon, 1);
  return std::all_of(edges.begin(), edges.end(), [&](const TileEdge& e) { return glm::dot(e.outward, point) < e.offset; });
}

PolygonTiling make_tiling(int number) {
  const Recipe from = recipe(number);
  PolygonTiling tiling;
  tiling.classes = from.classes;
  Bounds region;
  for (const int a : {0, 1}) {
    tiling.along[a] = from.along[a];
    for (const int b : {0, 1}) region.add(static_cast<double>(a) * from.along[0] + static_cast<double>(b) * from.along[1]);
  }
  std::vector<Polygon> polygons = translates(from.polygons, from.along, region);
  if (from.fill_with_triangles) {
    const Recipe grid = recipe(3);
    const std::vector<Polygon> placed = polygons;
    for (const Polygon& triangle : translates(grid.polygons, grid.along, region))
      if (std::none_of(placed.begin(), placed.end(), [&](const Polygon& p) { return contains(p, middle(triangle)); }))
        polygons.push_back(triangle);
  }
  for (const Polygon& polygon : polygons) {
    Tile tile;
    tile.color_class = polygon.color_class;
    tile.edges = edges_of(polygon, 1 / from.reach);
    for (const auto& [of_class, amount] : from.least)
      if (of_class == tile.color_class) tile.least = amount;
    for (const auto& [of_class, amount] : from.raised)
      if (of_class == tile.color_class) tile.raised = amount;
    // Three edges of tiling 22's dodecagon reach further, as the reference has it.
    if (number == 22 && tile.color_class == 2)
      for (TileEdge& e : tile.edges)
        if (std::fabs(e.outward.x) > 0.99 || e.outward.y < -0.99) e.scale = 3;
    tiling.tiles.push_back(std::move(tile));
  }
  return tiling;
}

}  // namespace

double PolygonTiling::value(dvec2 point) const {
  const dvec2 &u = along[0], &v = along[1];
  const double determinant = u.x * v.y - u.y * v.x;
  const double a = fast_floor((point.x * v.y - point.y * v.x) / determinant);
  const double b = fast_floor((u.x * point.y - u.y * point.x) / determinant);
  point -= a * u + b * v;

  // The tile that holds the point is the one in which it is farthest from the edges.
  double deepest = -std::numeric_limits<double>::infinity(), scaled = 0;
  const Tile* found = nullptr;
  for (const Tile& tile : tiles) {
    double depth = std::numeric_limits<double>::infinity(), tile_scaled = depth;
    for (const TileEdge& e : tile.edges) {
      const double d = e.offset - glm::dot(e.outward, point);
      depth = std::min(depth, d);
      tile_scaled = std::min(tile_scaled, d * e.scale);
      if (depth <= deepest) break;
    }
    if (depth <= deepest) continue;
    deepest = depth;
    scaled = tile_scaled;
    found = &tile;
  }
  if (found == nullptr) return 0;  // not a number
  const double edge = 1 - std::clamp(scaled, 0.0, 1.0);
  return (found->color_class + std::max(found->least, edge) + found->raised) / classes;
}

const PolygonTiling& polygon_tiling(int number) {
  static const std::vector<PolygonTiling> tilings = [] {
    std::vector<PolygonTiling> all;
    for (int i = 1; i <= 24; ++i) all.push_back(make_tiling(i));
    return all;
  }();
  return tilings[static_cast<std::size_t>(number - 1)];
}

}  // namespace lute
