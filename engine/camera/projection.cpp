#include "engine/camera/projection.hpp"

#include <array>
#include <cmath>

namespace lute {
namespace {

// A position in the image: u, v run over 0...1 from the lower left corner, a, b over -0.5...0.5, wide_a, wide_b over
// -1...1.
struct ImagePoint {
  double u, v;
  double a() const { return u - 0.5; }
  double b() const { return v - 0.5; }
  double wide_a() const { return 2 * u - 1; }
  double wide_b() const { return 2 * v - 1; }
};

using Project = bool (*)(const View&, const ImagePoint&, ProjectedRay&);

dvec3 unit_or_zero(const dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : v;
}

// Rodrigues' formula about a unit axis.
dvec3 rotated(const dvec3& q, const dvec3& axis, double angle) {
  return q * std::cos(angle) + glm::cross(axis, q) * std::sin(angle) +
         axis * (glm::dot(axis, q) * (1 - std::cos(angle)));
}

bool perspective(const View& view, const ImagePoint& p, ProjectedRay& ray) {
  ray.direction = view.direction + p.a() * view.right + p.b() * view.up;
  ray.pattern_point = {p.a(), p.b()};
  return true;
}

bool orthographic(const View& view, const ImagePoint& p, ProjectedRay& ray) {
  ray.direction = view.direction;
  ray.origin = view.location + p.a() * view.right + p.b() * view.up;
  ray.pattern_point = {p.a(), p.b()};
  return true;
}

// A direction given by its angle theta from the axis and phi around it.
dvec3 polar(const View& view, double phi, double theta) {
  return std::cos(phi) * std::sin(theta) * view.unit_right + std::sin(phi) * std::sin(theta) * view.unit_up +
         std::cos(theta) * view.unit_direction;
}

bool fisheye(const View& view, const ImagePoint& p, ProjectedRay& ray) {
  const double x = p.wide_a() * view.right_length, y = p.wide_b() * view.up_length;
  const double radius = std::sqrt(x * x + y * y);
  if (radius > 1) return false;
  const double phi = radius == 0 ? 0 : std::atan2(y, x);
  const double theta = radius * view.angle / 2;
  ray.direction = polar(view, phi, theta);
  ray.pattern_point = {phi, theta};
  return true;
}

bool ultra_wide_angle(const View& view, const ImagePoint& p, ProjectedRay& ray) {
  const double alpha = p.a() * view.angle, beta = p.b() * view.angle * view.up_length / view.right_length;
  ray.direction = std::sin(alpha) * view.unit_right + std::sin(beta) * view.unit_up +
                  std::cos(alpha) * std::cos(beta) * view.unit_direction;
  ray.pattern_point = {alpha, beta};
  return true;
}

// The projection of OMNIMAX domes, chapter 30 §3.1: a circle with its lower part cut off, theta a polynomial of the
// radius.
bool omnimax(const View& view, const ImagePoint& p, ProjectedRay& ray) {
  constexpr double kAspect = 1.283458;
  const double k = view.right_length / view.up_length;
  double x = p.wide_a(), y = p.wide_b();
  if (k > kAspect) {
    x *= k / kAspect;
    y = (y - 1) / kAspect + 1;
  } else if (k > 1) {
    y = (y - 1) / k + 1;
  } else {
    y /= k;
  }
  const double radius = std::sqrt(x * x + y * y);
  if (radius > 1) return false;
  const double phi = std::atan2(y, x);
  const double square = radius * radius;
  const double theta = radius * (1.411269 + square * (-0.09439 + square * 0.25674));
  if (std::sin(phi) * std::sin(theta) < std::tan(radians(135.0)) * std::cos(theta)) return false;
  ray.direction = polar(view, phi, theta);
  ray.pattern_point = {phi, theta};
  return true;
}

bool panoramic(const View& view, const ImagePoint& p, ProjectedRay& ray) {
  const double alpha = (1 - p.u) * kPi, beta = p.wide_b() * kPi / 2;
  const bool at_pole = std::abs(kPi / 2 - std::abs(beta)) < kEpsilon;
  const double height = at_pole ? std::copysign(2e10, beta) : std::tan(beta);
  ray.direction = std::cos(alpha) * view.right + height * view.up + std::sin(alpha) * view.direction;
  ray.pattern_point = {alpha, beta};
  return true;
}

// The cylinder cameras: an angle across (1, 3) or along (2, 4), and on the other axis a slope (1, 2) or a moved origin
// (3, 4).
bool cylinder_1(const View& view, const ImagePoint& p, ProjectedRay& ray) {
  const double alpha = p.a() * view.angle, y = p.b() * view.up_length;
  ray.direction = std::sin(alpha) * view.unit_right + y * view.unit_up + std::cos(alpha) * view.unit_direction;
  ray.pattern_point = {alpha, y};
  return true;
}

bool cylinder_2(const View& view, const ImagePoint& p, ProjectedRay& ray) {
  const double beta = p.b() * view.angle, x = p.a() * view.right_length;
  ray.direction = x * view.unit_right + std::sin(beta) * view.unit_up + std::cos(beta) * view.unit_direction;
  ray.pattern_point = {x, beta};
  return true;
}

bool cylinder_3(const View& view, const ImagePoint& p, ProjectedRay& ray) {
  const double alpha = p.a() * view.angle;
  ray.direction = std::sin(alpha) * view.unit_right + std::cos(alpha) * view.unit_direction;
  ray.origin = view.location + p.b() * view.up;
  ray.pattern_point = {alpha, p.b() * view.up_length};
  return true;
}

bool cylinder_4(const View& view, const ImagePoint& p, ProjectedRay& ray) {
  const double beta = p.b() * view.angle;
  ray.direction = std::sin(beta) * view.unit_up + std::cos(beta) * view.unit_direction;
  ray.origin = view.location + p.a() * view.right;
  ray.pattern_point = {p.a() * view.right_length, beta};
  return true;
}

bool spherical(const View& view, const ImagePoint& p, ProjectedRay& ray) {
  const double across = p.a() * view.horizontal_angle, along = p.b() * view.vertical_angle;
  const dvec3 tilted = rotated(view.direction, view.unit_right, -along);
  ray.direction = rotated(tilted, view.unit_up, across);
  ray.pattern_point = {across, along};
  return true;
}

// In the order of CameraKind; kMesh is last and has none.
constexpr std::array<Project, 11> kProjections{perspective, orthographic, fisheye,    ultra_wide_angle,
                                               omnimax,     panoramic,    cylinder_1, cylinder_2,
                                               cylinder_3,  cylinder_4,   spherical};

}  // namespace

Projection::Projection(const Camera& camera, int width, int height)
    : view_{camera.location,
            camera.direction,
            camera.right,
            camera.up,
            unit_or_zero(camera.direction),
            unit_or_zero(camera.right),
            unit_or_zero(camera.up),
            glm::length(camera.right),
            glm::length(camera.up),
            radians(camera.angle),
            radians(camera.horizontal_angle),
            radians(camera.vertical_angle)},
      kind_(camera.kind),
      width_(width),
      height_(height) {
  if (kind_ == CameraKind::kMesh) mesh_.emplace(camera, width, height);
}

bool Projection::project(dvec2 position, ProjectedRay& ray, int index) const {
  if (mesh_) return mesh_->project(position, index, ray);
  ray.origin = view_.location;
  // Counted from the lower edge before the division, as the reference does: to the last bit, which patterns with a step in a plane show.
  const ImagePoint point{(position.x + 0.5) / width_, (height_ - position.y - 0.5) / height_};
  return kProjections[static_cast<std::size_t>(kind_)](view_, point, ray);
}

}  // namespace lute
