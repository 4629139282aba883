#include "engine/texture/pattern/pavement.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/math/rounding.hpp"
#include "engine/texture/pattern/pavement_tiles.hpp"

namespace lute {
namespace {

const double kRoot3 = std::sqrt(3.0), kHeight = kRoot3 / 2, kInradius = 1 / (2 * kRoot3);

// The number of a cell along an axis; far away it is meaningless, but must not be undefined.
int cell_of(double c) { return static_cast<int>(bounded(fast_floor(c), 1e8)); }

// Which kind a written number means; the reference keeps it in a byte without sign.
int kind_of(int written, int kinds) { return static_cast<std::uint8_t>(written) % kinds; }

// The unit square around the point, seen from one of its corners.
struct SquareCorner {
  double a, b;  // twice the distance along x and z
  bool x_edge_drawn, z_edge_drawn;  // the edge that lies at this corner's x, at its z
  bool diagonal_differs;
  bool corner() const { return x_edge_drawn && z_edge_drawn; }
  bool inner() const { return !x_edge_drawn && !z_edge_drawn && diagonal_differs; }
};

double bend(int form, double a, double b) {
  switch (form) {
    case 0: return std::max({a - 1, b - 1, std::min(1 - a, 1 - b)});
    case 1: return std::min(1.0, std::fabs(a + b - 1));
    default: return std::min(1.0, std::fabs(std::sqrt(a * a + b * b) - 1));
  }
}

double square_value(const Pavement& pattern, const PavementTiles& tiles, double x, double z) {
  const int i = cell_of(x), j = cell_of(z);
  const double fx = x - i, fz = z - j;
  const TileName own = tiles.square(i, j);
  const auto differs = [&](int di, int dj) { return !(tiles.square(i + di, j + dj) == own); };
  const bool drawn_x[2] = {differs(-1, 0), differs(1, 0)}, drawn_z[2] = {differs(0, -1), differs(0, 1)};
  SquareCorner corners[4];
  for (int k = 0; k < 4; ++k) {
    const int right = k & 1, up = k >> 1;
    corners[k] = {2 * (right ? 1 - fx : fx), 2 * (up ? 1 - fz : fz), drawn_x[right], drawn_z[up], differs(2 * right - 1, 2 * up - 1)};
  }
  const int drawn = drawn_x[0] + drawn_x[1] + drawn_z[0] + drawn_z[1];
  const int form = kind_of(pattern.form, 4), interior = kind_of(pattern.interior, 3), exterior = kind_of(pattern.exterior, 3);
  if (form != 3 && drawn == 2)
    for (int k = 0; k < 4; ++k)
      if (corners[k].inner() && corners[3 - k].corner()) return bend(form, corners[k].a, corners[k].b);

  double value = 0;
  for (const SquareCorner& c : corners) {
    if (c.x_edge_drawn) value = std::max(value, 1 - c.a);
    if (c.z_edge_drawn) value = std::max(value, 1 - c.b);
    if (c.inner()) {
      const double round = 1 - std::sqrt(c.a * c.a + c.b * c.b);
      value = std::max(value, interior == 0 ? std::min(1 - c.a, 1 - c.b) : interior == 1 ? 1 - (c.a + c.b) : round);
    }
    if (c.corner() && exterior == 1) value = std::max(value, std::min(1.0, 2 - (c.a + c.b)));
    if (c.corner() && exterior == 2 && c.a < 1 && c.b < 1)
      value = std::max(value, std::min(1.0, std::sqrt((1 - c.a) * (1 - c.a) + (1 - c.b) * (1 - c.b))));
  }
  return value;
}

// A unit triangle: a point of the grid is m (1, 0) + n (1/2, height).
struct GridPoint {
  int m, n;
  dvec2 place() const { return {m + 0.5 * n, n * kHeight}; }
};
struct Triangle {
  int i, j;
  bool up;

  GridPoint corner(int k) const {
    static constexpr int kUp[3][2] = {{0, 0}, {1, 0}, {0, 1}}, kDown[3][2] = {{1, 0}, {1, 1}, {0, 1}};
    const auto& o = up ? kUp[k] : kDown[k];
    return {i + o[0], j + o[1]};
  }
  // The triangle across the edge that lies opposite corner k.
  Triangle across(int k) const {
    static constexpr int kUp[3][2] = {{0, 0}, {-1, 0}, {0, -1}}, kDown[3][2] = {{0, 1}, {0, 0}, {1, 0}};
    const auto& o = up ? kUp[k] : kDown[k];
    return {i + o[0], j + o[1], !up};
  }
};

// The tiles of a pavement of triangles, or of hexagons cut into six triangles.
class TriangleTiles {
 public:
  TriangleTiles(const PavementTiles& tiles, bool hexagons) : tiles_(tiles), hexagons_(hexagons) {}

  TileName name(const Triangle& t) const {
    if (!hexagons_) return tiles_.triangle(t.i, t.j, t.up);
    for (int k = 0; k < 3; ++k) {
      // Exactly one corner is a hexagon's centre: (1, 0) + i (1, 1) + j (-1, 2).
      const GridPoint c = t.corner(k);
      const int three_j = c.n - c.m + 1;
      if (three_j % 3 == 0) return tiles_.hexagon(c.m - 1 + three_j / 3, three_j / 3);
    }
    return {};
  }

  // Does the grid point touch another tile than `own`?
  bool on_border(const GridPoint& v, const TileName& own) const {
    const Triangle around[6] = {{v.m, v.n, true},      {v.m - 1, v.n, false},    {v.m - 1, v.n, true},
                                {v.m - 1, v.n - 1, false}, {v.m, v.n - 1, true}, {v.m, v.n - 1, false}};
    return std::any_of(std::begin(around), std::end(around), [&](const Triangle& t) { return !(name(t) == own); });
  }

 private:
  const PavementTiles& tiles_;
  bool hexagons_;
};

// The triangle that holds the point.
class TriangleView {
 public:
  TriangleView(const Pavement& pattern, const TriangleTiles& tiles, dvec2 point)
      : sides_(pattern.sides), form_(kind_of(pattern.form, 3)), interior_(kind_of(pattern.interior, 3)),
        exterior_(kind_of(pattern.exterior, 3)), tiles_(tiles), point_(point) {
    const double v = point.y / kHeight, u = point.x - v / 2;
    triangle_ = {cell_of(u), cell_of(v), true};
    triangle_.up = (u - triangle_.i) + (v - triangle_.j) < 1;
    own_ = tiles_.name(triangle_);
    for (int k = 0; k < 3; ++k) {
      drawn_[k] = !(tiles_.name(triangle_.across(k)) == own_);
      corner_[k] = triangle_.corner(k).place();
    }
    centroid_ = (corner_[0] + corner_[1] + corner_[2]) / 3.0;
  }

  double value() const {
    double value = 0;
    for (int k = 0; k < 3; ++k)
      if (drawn_[k]) value = std::max(value, 1 - edge_distance(k) / kInradius);
    for (int k = 0; k < 3; ++k)
      if (!drawn_[next(k)] && !drawn_[last(k)] && tiles_.on_border(triangle_.corner(k), own_)) value = std::max(value, inner_vertex(k));
    if (sides_ == 3 && exterior_ != 0)
      for (int k = 0; k < 3; ++k)
        if (drawn_[next(k)] && drawn_[last(k)]) value = outer_corner(k, value);
    if (form_ == 1 || form_ == 2)
      for (int k = 0; k < 3; ++k)
        if (in_kite(k)) {
          if (is_wide_corner(k, next(k))) return wide_corner(k, next(k));
          if (is_wide_corner(k, last(k))) return wide_corner(k, last(k));
        }
    return value;
  }

 private:
  static int next(int k) { return (k + 1) % 3; }
  static int last(int k) { return (k + 2) % 3; }

  // Edge k lies opposite corner k.
  double edge_distance(int k) const { return kHeight - vertex_line_distance(k); }
  // From the line through corner k parallel to the opposite edge.
  double vertex_line_distance(int k) const {
    const dvec2 down = glm::normalize(centroid_ - corner_[k]);
    return glm::dot(point_ - corner_[k], down);
  }
  // Projection of the point on the edge from corner k to corner `to`.
  double along(int k, int to) const { return glm::dot(point_ - corner_[k], corner_[to] - corner_[k]); }
  bool in_kite(int k) const { return along(k, next(k)) < 0.5 && along(k, last(k)) < 0.5; }

  double inner_vertex(int k) const {
    switch (interior_) {
      case 0: return 1 - vertex_line_distance(k) / kInradius;
      case 1: return in_kite(k) ? std::min(1 - 3 * along(k, next(k)), 1 - 3 * along(k, last(k))) : 0;
      default: return 1 - 3 * glm::length(point_ - corner_[k]);
    }
  }

  double outer_corner(int k, double value) const {
    const dvec2 from_centroid = point_ - centroid_;
    if (exterior_ == 1) {
      if (edge_distance(next(k)) > kInradius || edge_distance(last(k)) > kInradius) return value;
      return std::min(1.0, std::fabs(glm::dot(from_centroid, glm::normalize(corner_[k] - centroid_))) / kInradius);
    }
    return in_kite(k) ? std::min(1.0, glm::length(from_centroid) / kInradius) : value;
  }

  // Corner k where the border turns by 120 degrees: edge `open` at it is not drawn, the other one is, and so is the other edge at
  // this corner of the triangle beyond `open`.
  bool is_wide_corner(int k, int open) const {
    const int other = 3 - k - open;
    if (drawn_[open] || !drawn_[other]) return false;
    const Triangle beyond = triangle_.across(open);
    const GridPoint v = triangle_.corner(k), far_end = triangle_.corner(other);
    for (int c = 0; c < 3; ++c) {
      const GridPoint g = beyond.corner(c);
      // The other edge at v lies opposite the far end of the open edge.
      if (g.m == far_end.m && g.n == far_end.n && !(g.m == v.m && g.n == v.n)) return !(tiles_.name(beyond.across(c)) == own_);
    }
    return false;
  }
  double wide_corner(int k, int open) const {
    const int far_end = 3 - k - open;
    if (form_ == 1) return std::min(1.0, std::fabs(2 - 4 * along(k, far_end)));
    return std::clamp((glm::length(point_ - corner_[far_end]) - 1 / kRoot3) / kInradius, 0.0, 1.0);
  }

  int sides_, form_, interior_, exterior_;
  const TriangleTiles& tiles_;
  dvec2 point_, corner_[3], centroid_{0, 0};
  Triangle triangle_{0, 0, true};
  TileName own_;
  bool drawn_[3];
};

}  // namespace

double evaluate(const Pavement& pattern, const dvec3& p, const PatternContext&) {
  const PavementTiles* tiles = find_pavement(pattern.sides, pattern.tiles, pattern.pattern);
  if (tiles == nullptr) return 0;
  if (pattern.sides == 4) return square_value(pattern, *tiles, p.x, p.z);
  const TriangleTiles triangles(*tiles, pattern.sides == 6);
  return TriangleView(pattern, triangles, {p.x, p.z}).value();
}

int pavement_pattern_count(int sides, int tiles) {
  int count = 0;
  for (const PavementEntry& entry : kPavements) count += entry.sides == sides && entry.tiles == tiles;
  return count;
}

}  // namespace lute
