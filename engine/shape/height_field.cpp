#include "engine/shape/height_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/shape/height_pyramid.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

constexpr double kFullHeight = 65536;
constexpr double kSlabSlack = 0.001;  // of the box, in units of height
constexpr double kCellSlack = 1e-4;   // triangles reach this much into their neighbours
constexpr int kFirstLevel = 2;        // of squares: most rays begin or arrive near the heights, and soon climb where they do not
constexpr double kNever = std::numeric_limits<double>::infinity();

// Normals at the grid's points: each component is a 16-bit integer, as the reference keeps them.
using VertexNormal = std::array<std::int16_t, 3>;

class VertexNormals {
 public:
  explicit VertexNormals(const HeightGrid& grid) : width_(grid.width) {
    normals_.reserve(grid.heights.size());
    for (int z = 0; z < grid.depth; ++z)
      for (int x = 0; x < grid.width; ++x) normals_.push_back(quantised(at_vertex(grid, x, z)));
  }
  const VertexNormal& at(int x, int z) const {
    return normals_[static_cast<std::size_t>(z) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  }

 private:
  static VertexNormal quantised(const dvec3& n) {
    const auto component = [](double v) { return static_cast<std::int16_t>(32767 * v); };
    return {component(n.x), component(n.y), component(n.z)};
  }

  // The mean of the normals of the four triangles between the vertex and its neighbours.
  static dvec3 at_vertex(const HeightGrid& grid, int x, int z) {
    const bool west = x > 0, east = x + 1 < grid.width, south = z > 0, north = z + 1 < grid.depth;
    const int here = grid.at(x, z);
    const double to_west = west ? here - grid.at(x - 1, z) : 0, to_east = east ? grid.at(x + 1, z) - here : 0;
    const double to_south = south ? here - grid.at(x, z - 1) : 0, to_north = north ? grid.at(x, z + 1) - here : 0;
    dvec3 sum(0);
    const auto add = [&](double slope_x, double slope_z) { sum += glm::normalize(dvec3(-slope_x, 1, -slope_z)); };
    if (east && north) add(to_east, to_north);
    if (north && west) add(to_west, to_north);
    if (west && south) add(to_west, to_south);
    if (south && east) add(to_east, to_south);
    return glm::normalize(sum);
  }

  int width_;
  std::vector<VertexNormal> normals_;
};

template <class Made, class Make>
std::shared_ptr<const Made> shared(BuildContext& context, const void* key, Make&& make) {
  if (auto found = context.find_shared(key)) return std::static_pointer_cast<const Made>(found);
  auto made = std::make_shared<const Made>(make());
  context.store_shared(key, made);
  return made;
}

// A hit keeps its cell (x, z) and which of its triangles it is on (part 0: lower, 1: upper).
class Landscape final : public ScannedShape<Landscape> {
 public:
  Landscape(const HeightField& field, const SharedTransform& to_world, BuildContext& context) : grid_(field.grid) {
    const HeightGrid& grid = *grid_;
    pyramid_ = shared<HeightPyramid>(context, grid_.get(), [&] { return HeightPyramid(grid); });
    if (field.smooth) normals_ = shared<VertexNormals>(context, &grid.heights, [&] { return VertexNormals(grid); });
    const Transform unit = Transform::scale({1.0 / (grid.width - 1), 1 / kFullHeight, 1.0 / (grid.depth - 1)});
    to_world_ = to_world.identity() ? unit : unit.then(to_world);
    low_ = std::max<double>(pyramid_->all().lo, kFullHeight * field.water_level) - kSlabSlack;
    high_ = pyramid_->all().hi + kSlabSlack;
  }

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    const Ray local = to_world_->inverse_ray(ray);
    const dvec3 reciprocal = 1.0 / local.direction;
    if (!cut(local, reciprocal, {0, low_, 0}, {grid_->width - 1.0, high_, grid_->depth - 1.0}, range)) return;
    // From square to square along the ray: down a level where the ray may meet the heights, up again where it leaves a larger square.
    const dvec3& o = local.origin;
    const dvec3& d = local.direction;
    const int columns = grid_->width - 1, rows = grid_->depth - 1, coarsest = pyramid_->levels() - 1;
    const int ahead_x = d.x > 0 ? 1 : 0, ahead_z = d.z > 0 ? 1 : 0;
    const bool along_z = d.x == 0, along_x = d.z == 0;
    double t = range.lo;
    int x = std::clamp(static_cast<int>(o.x + t * d.x), 0, columns - 1), z = std::clamp(static_cast<int>(o.z + t * d.z), 0, rows - 1);
    for (int level = std::min(coarsest, kFirstLevel);;) {
      const int square_x = x >> level, square_z = z >> level;
      const int border_x = (square_x + ahead_x) << level, border_z = (square_z + ahead_z) << level;
      const double leave_x = along_z ? kNever : (border_x - o.x) * reciprocal.x;
      const double leave_z = along_x ? kNever : (border_z - o.z) * reciprocal.z;
      const double leave = std::min(std::min(leave_x, leave_z), range.hi);
      const double y0 = o.y + t * d.y, y1 = o.y + leave * d.y;
      const HeightPyramid::Range heights = pyramid_->range(level, square_x, square_z);
      if (std::max(y0, y1) >= heights.lo - kSlabSlack && std::min(y0, y1) <= heights.hi + kSlabSlack) {
        if (level > 0) {
          --level;
          continue;
        }
        if (scan_cell(x, z, local, range, sink)) return;
      }
      if (leave >= range.hi) return;
      t = std::max(t, leave);
      const bool over_x = leave_x <= leave_z;
      if (over_x) {
        x = border_x + ahead_x - 1;
        if (x < 0 || x >= columns) return;
        z = std::clamp(static_cast<int>(o.z + t * d.z), square_z << level, std::min((square_z + 1) << level, rows) - 1);
      } else {
        z = border_z + ahead_z - 1;
        if (z < 0 || z >= rows) return;
        x = std::clamp(static_cast<int>(o.x + t * d.x), square_x << level, std::min((square_x + 1) << level, columns) - 1);
      }
      if (level < coarsest && (((over_x ? border_x : border_z) >> level) & 1) == 0) ++level;
    }
  }

  Aabb bounds() const override { return to_world_->box({{0, low_, 0}, {grid_->width - 1.0, high_, grid_->depth - 1.0}}); }
  // The ground has no bottom. Each corner of the box goes as far as the signs of the matrix carry it; zero times the depth is zero.
  Aabb inside_bounds() const override {
    const Aabb ground{{0, -kNever, 0}, {grid_->width - 1.0, high_, grid_->depth - 1.0}};
    Aabb box{to_world_->translation, to_world_->translation};
    for (int axis = 0; axis < 3; ++axis)
      for (int own = 0; own < 3; ++own) {
        const double factor = to_world_->linear[own][axis];
        if (factor == 0) continue;
        box.lo[axis] += factor * (factor > 0 ? ground.lo : ground.hi)[own];
        box.hi[axis] += factor * (factor > 0 ? ground.hi : ground.lo)[own];
      }
    return box;
  }
  bool inside(const dvec3& point) const override {
    const dvec3 p = to_world_->inverse_point(point);
    if (!(p.x >= 0 && p.x < grid_->width - 1 && p.z >= 0 && p.z < grid_->depth - 1) || p.y >= high_) return false;
    if (p.y < low_) return true;
    const int x = static_cast<int>(p.x);
    const int z = static_cast<int>(p.z);
    const double s = p.x - x;
    const double r = p.z - z;
    const auto height = [&](int i, int k) { return std::max<double>(grid_->at(i, k), low_); };
    const double y2 = height(x + 1, z);
    const double y3 = height(x, z + 1);
    if (s + r < 1) {
      const double y1 = height(x, z);
      return p.y < y1 + s * (y2 - y1) + r * (y3 - y1);
    }
    const double y4 = height(x + 1, z + 1);
    return p.y < y4 + (1 - s) * (y3 - y4) + (1 - r) * (y2 - y4);
  }
  dvec3 normal(const ShapeHit& hit, const dvec3& point) const override {
    const int x = static_cast<int>(hit.data[0]);
    const int z = static_cast<int>(hit.data[1]);
    if (!normals_) return glm::normalize(to_world_->normal(face_normal(x, z, hit.part)));
    const dvec3 p = to_world_->inverse_point(point);
    const int i = std::clamp(static_cast<int>(std::floor(p.x)), 0, grid_->width - 2);
    const int k = std::clamp(static_cast<int>(std::floor(p.z)), 0, grid_->depth - 2);
    const double s = p.x - i;
    const double r = p.z - k;
    const auto at = [&](int a, int b) {
      const VertexNormal& n = normals_->at(a, b);
      return glm::normalize(to_world_->normal({n[0], n[1], n[2]}));
    };
    return glm::normalize((1 - r) * ((1 - s) * at(i, k) + s * at(i + 1, k)) +
                          r * ((1 - s) * at(i, k + 1) + s * at(i + 1, k + 1)));
  }

 private:
  // Cuts `range` down to the ray's passage through a box. `reciprocal` is that of the direction: divisions would take half the time.
  static bool cut(const Ray& ray, const dvec3& reciprocal, const dvec3& lo, const dvec3& hi, Interval& range) {
    for (int axis = 0; axis < 3; ++axis) {
      const double p = ray.origin[axis];
      if (ray.direction[axis] == 0) {
        if (p < lo[axis] || p > hi[axis]) return false;
        continue;
      }
      double near = (lo[axis] - p) * reciprocal[axis];
      double far = (hi[axis] - p) * reciprocal[axis];
      if (near > far) std::swap(near, far);
      range = {std::max(range.lo, near), std::min(range.hi, far)};
    }
    return !range.empty();
  }

  dvec3 face_normal(int x, int z, std::uint32_t upper) const {
    const double y2 = grid_->at(x + 1, z);
    const double y3 = grid_->at(x, z + 1);
    if (upper) {
      const double y4 = grid_->at(x + 1, z + 1);
      return {y3 - y4, 1, y2 - y4};
    }
    const double y1 = grid_->at(x, z);
    return {y1 - y2, 1, y1 - y3};
  }

  // True if the sink needs no farther hit.
  template <class Sink>
  bool scan_cell(int x, int z, const Ray& ray, Interval range, Sink& sink) const {
    bool enough = false;
    for (const std::uint32_t upper : {0u, 1u}) {
      const int i = upper ? x + 1 : x;
      const int k = upper ? z + 1 : z;
      const dvec3 n = face_normal(x, z, upper);
      const double slope = glm::dot(n, ray.direction);
      if (slope == 0) continue;
      const double t = glm::dot(n, dvec3(i, grid_->at(i, k), k) - ray.origin) / slope;
      if (!range.contains(t)) continue;
      const double s = ray.origin.x + t * ray.direction.x - x;
      const double r = ray.origin.z + t * ray.direction.z - z;
      const bool within = upper ? s <= 1 + kCellSlack && r <= 1 + kCellSlack && s + r >= 1 - kCellSlack
                                : s >= -kCellSlack && r >= -kCellSlack && s + r <= 1 + kCellSlack;
      if (within) enough |= sink(t, upper, std::array<double, 3>{static_cast<double>(x), static_cast<double>(z), 0});
    }
    return enough;
  }

  std::shared_ptr<const HeightGrid> grid_;
  std::shared_ptr<const HeightPyramid> pyramid_;
  std::shared_ptr<const VertexNormals> normals_;  // null: flat triangles
  double low_ = 0, high_ = 0;                     // of the box, in units of height
  SharedTransform to_world_;
};

}  // namespace

std::unique_ptr<Shape> build(const HeightField& field, const SharedTransform& to_world, BuildContext& context) {
  return std::make_unique<Landscape>(field, to_world, context);
}

}  // namespace lute
