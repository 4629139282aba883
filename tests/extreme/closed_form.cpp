#include "tests/extreme/closed_form.hpp"

#include <algorithm>
#include <cmath>

namespace lute::extreme {
namespace {

constexpr Rgb kYellow{1, 1, 0}, kGreen{0, 0.5, 0}, kBlue{0, 0, 1};

// Object where `inside` > 0; no answer at `undecided` and nearer to 0.
std::optional<Rgb> object_by_sign(Real inside, double undecided) {
  if (magnitude(inside) <= undecided) return std::nullopt;
  return inside > 0 ? kYellow : kBlue;
}

// Bands of width 1: green from even to odd numbers, then yellow.
std::optional<Rgb> band(Real value) {
  constexpr double kUndecided = 1e-9;
  if (magnitude(value - whole(value + Real{0.5})) <= kUndecided * (1 + magnitude(value))) return std::nullopt;
  const Real cell = whole(value);
  return cell - 2 * whole(cell / 2) == 0 ? kGreen : kYellow;
}

struct Vector {
  Real x, y, z;
};
Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator*(Real s, Vector v) { return {s * v.x, s * v.y, s * v.z}; }
Real dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// Turns v about axis 0, 1 or 2. Sine and cosine are those of doubles: good to 1e-16 of a picture.
Vector turned(Vector v, double degrees, int axis) {
  const double angle = degrees * 3.14159265358979323846 / 180;
  const Real c = std::cos(angle), s = std::sin(angle);
  if (axis == 0) return {v.x, c * v.y - s * v.z, s * v.y + c * v.z};
  if (axis == 1) return {c * v.x + s * v.z, v.y, -s * v.x + c * v.z};
  return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

// The part of a ray that is between two parallel planes, axis after axis.
struct Slabs {
  Real enter = -100, leave = 100;

  void cut(Real from, Real direction, Real low, Real high) {
    if (magnitude(direction) < 1e-20) {
      if (from < low || from > high) leave = enter - 1;
      return;
    }
    enter = std::max(enter, std::min((low - from) / direction, (high - from) / direction));
    leave = std::min(leave, std::max((low - from) / direction, (high - from) / direction));
  }
};

using Point = std::array<double, 2>;

Real distance_to_segment(Real x, Real y, const Point& from, const Point& to) {
  const Real dx = to[0] - Real{from[0]}, dy = to[1] - Real{from[1]}, px = x - from[0], py = y - from[1];
  const Real t = std::clamp((px * dx + py * dy) / (dx * dx + dy * dy), Real{0}, Real{1});
  const Real ex = px - t * dx, ey = py - t * dy;
  return square_root(ex * ex + ey * ey);
}

// The least value of f between low and high, where it has one minimum.
template <typename Function>
Real least_between(Function f, Real low, Real high) {
  for (int step = 0; step < 120; ++step) {
    const Real third = (high - low) / 3;
    if (f(low + third) < f(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  return f(low);
}

}  // namespace

// Ray (0, 1, 0) + t (a 4/3 0.008, 0.008 b, 1); the planet's centre is R below the origin.
ClosedForm planet() {
  return [](Real a, Real b) -> std::optional<Rgb> {
    const Real radius = 6400000;
    const Vector direction{a * 4 / 3 * Real{0.008}, Real{0.008} * b, 1}, from{0, 1 + radius, 0};
    const Real half_b = dot(direction, from), c = 2 * radius + 1;  // |from|² - R², with nothing lost
    const Real discriminant = half_b * half_b - dot(direction, direction) * c;
    if (magnitude(discriminant) <= 1e-9 * half_b * half_b) return std::nullopt;
    if (discriminant < 0 || half_b > 0) return kBlue;
    return band(c / (-half_b + square_root(discriminant)) / 100);  // z of the nearer root: direction.z is 1
  };
}

ClosedForm sphere_rim() {
  return [](Real a, Real b) {
    const Real x = Real{4e-9} * a, y = Real{1.2e-4} * b;
    return object_by_sign(-(2 * x + x * x + y * y), 1e-15);  // 1 - (1 + x)² - y²
  };
}

ClosedForm grazed_floor() {
  return [](Real, Real b) -> std::optional<Rgb> {
    if (b >= 0) return kBlue;
    return band(-1 / b + Real{0.3});  // off the whole numbers that the rows of a picture meet
  };
}

ClosedForm torus_along_its_axis(double minor) {
  return [minor](Real a, Real b) {
    const Real r = minor, x = 1 + 4 * r * a, z = 3 * r * b;
    return object_by_sign(r - magnitude(square_root(x * x + z * z) - 1), 1e-15);
  };
}

// Hit where the least distance of the ray from the circle in the tube is below its radius.
ClosedForm torus_from_a_slant(double minor) {
  return [minor](Real a, Real b) {
    const Vector direction{0, Real{-0.6}, Real{0.8}};
    const Vector from = Vector{3 * a, 3, -4} + Real{2.25} * b * Vector{0, Real{0.8}, Real{0.6}};
    const auto off = [&](Real t) {
      const Vector p = from + t * direction;
      const Real ring = square_root(p.x * p.x + p.z * p.z) - 1;
      return ring * ring + p.y * p.y;
    };
    constexpr int kSteps = 400;
    const auto at = [](int i) { return Real{3} + Real{4} * i / kSteps; };
    Real least = 100;
    for (int i = 1; i < kSteps; ++i) {
      if (off(at(i)) > off(at(i - 1)) || off(at(i)) > off(at(i + 1))) continue;
      least = std::min(least, least_between(off, at(i - 1), at(i + 1)));
    }
    return object_by_sign(minor - square_root(least), 1e-9);
  };
}

ClosedForm everywhere() {
  return [](Real, Real) { return std::optional(kYellow); };
}

ClosedForm nowhere() {
  return [](Real, Real) { return std::optional(kBlue); };
}

ClosedForm box_edge() {
  // The doubles around 1 are 2.2e-16 apart, a pixel is 1.5e-14 wide.
  return [](Real a, Real) { return object_by_sign(-Real{1.2e-12} * a, 4.5e-16); };
}

// Ray (0, 0, -2) + t (4/3 a, b, 1), at z = 1/8.
ClosedForm first_sheet() {
  return [](Real a, Real b) -> std::optional<Rgb> {
    const Real t = Real{17} / 8, x = 8 * t * a * 4 / 3, y = 8 * t * b;
    if (!band(x) || !band(y)) return std::nullopt;
    return band(whole(x) + whole(y) + Real{0.5});
  };
}

// Its faces look to the corners of a dodecahedron, which are √3 away.
ClosedForm icosahedron() {
  return [](Real a, Real b) {
    const Real golden = (1 + square_root(5)) / 2, short_side = golden - 1, distance = square_root(3);
    const Vector from{4 * a, 3 * b, -5};
    Real enter = -100, leave = 100;
    bool missed = false;
    const auto cut = [&](Vector normal) {
      const Real beyond = dot(normal, from) - distance;
      if (normal.z == 0) {
        missed = missed || beyond > 0;
      } else if (normal.z < 0) {
        enter = std::max(enter, beyond / -normal.z);
      } else {
        leave = std::min(leave, -beyond / normal.z);
      }
    };
    for (const int i : {-1, 1}) {
      for (const int j : {-1, 1}) {
        for (const int k : {-1, 1}) cut({Real(i), Real(j), Real(k)});
        cut({0, i * short_side, j * golden});
        cut({i * short_side, j * golden, 0});
        cut({j * golden, 0, i * short_side});
      }
    }
    return object_by_sign(missed ? Real{-1} : leave - enter, 1e-9);
  };
}

ClosedForm turned_box() {
  return [](Real a, Real b) {
    // The ray taken back into the box's space.
    const auto back = [](Vector v) { return turned(turned(turned(v, -10, 2), -30, 1), -20, 0); };
    const Vector from = back({4 * a, 3 * b, -5}), direction = back({0, 0, 1});
    Slabs slabs;
    slabs.cut(from.x, direction.x, -1, 1);
    slabs.cut(from.y, direction.y, -1, 1);
    slabs.cut(from.z, direction.z, -1, 1);
    return object_by_sign(slabs.leave - slabs.enter, 1e-9);
  };
}

// Every surface of the box shows half of its own red and half of what is behind it.
ClosedForm clear_box_on_floor() {
  return [](Real a, Real b) -> std::optional<Rgb> {
    const Real up = 2 * b / square_root(13);
    const Vector direction{a * 8 / 3, -2 + 3 * up, 3 + 2 * up};
    Slabs slabs;
    slabs.cut(0, direction.x, -1, 1);
    slabs.cut(2, direction.y, 0, Real{0.3});
    slabs.cut(-3, direction.z, -1, 1);
    if (magnitude(slabs.leave - slabs.enter) < 1e-5) return std::nullopt;
    const Rgb behind = direction.y < 0 ? Rgb{0, 1, 0} : kBlue;
    if (slabs.leave < slabs.enter) return behind;
    return Rgb{0.75 + 0.25 * behind[0], 0.25 * behind[1], 0.25 * behind[2]};
  };
}

ClosedForm shells() {
  return [](Real a, Real b) -> std::optional<Rgb> {
    const Real radius = square_root(16 * a * a + 9 * b * b);
    int hit = 0;
    for (int i = 1; i <= 200; ++i) {
      const Real shell = 1 + static_cast<Real>(i) / 200;
      if (magnitude(shell - radius) < 1e-9) return std::nullopt;
      hit += shell > radius ? 1 : 0;
    }
    const double light = std::pow(0.996, 2 * hit);
    return Rgb{light, light, light};
  };
}

// Bouguer's law: n r sin(angle to the radius) is the ray's distance p from the centre all along its way. At the radius r between
// densities n outside and m inside it turns by asin(p / (n r)) - asin(p / (m r)) toward the axis, and once more where it leaves.
ClosedForm glass_shells() {
  return [](Real a, Real b) -> std::optional<Rgb> {
    constexpr int kShells = 200, kLevels = 256;
    const auto density = [](int shell) { return shell > kShells ? Real{1} : 1 + static_cast<Real>(201 - shell) / 2000; };
    const Real x = 4 * a, p = square_root(16 * a * a + 9 * b * b);
    int surfaces = 0;
    // Sine and cosine of the whole turn, by the theorem of addition.
    Real sine = 0, cosine = 1;
    const auto turn = [&](Real s, Real c) {
      const Real sum = sine * c + cosine * s;
      cosine = cosine * c - sine * s;
      sine = sum;
    };
    const auto other = [](Real s) { return square_root(1 - s * s); };
    for (int shell = kShells; shell >= 1; --shell) {
      const Real radius = 1 + static_cast<Real>(shell) / 200;
      const Real outside = p / (density(shell + 1) * radius), inside = p / (density(shell) * radius);
      if (magnitude(outside - 1) < 1e-9) return std::nullopt;
      if (outside > 1) break;
      surfaces += 2;
      for (int side = 0; side < 2; ++side) {
        turn(outside, other(outside));
        turn(-inside, other(inside));
      }
    }
    if (surfaces > kLevels - 3 && surfaces < kLevels + 3) return std::nullopt;
    if (surfaces > kLevels) return Rgb{0, 0, 0};
    const Real at_wall = (p - 3 * sine) / cosine;
    return band(4 * x / p * at_wall);
  };
}

// The ray (4a - 2s, 3b, -2) + t (s, 0, 1) enters the slab at x = 4a and leaves it tan(b) further on, with
// sin b = sin a / ior, tan a = s.
ClosedForm slab_before_stripes(double ior, double slant) {
  return [ior, slant](Real a, Real) {
    const Real s = slant, sine = s / square_root(1 + s * s) / Real{ior};
    const Real inside = sine / square_root(1 - sine * sine);
    return band(4 * (4 * a + inside + s));
  };
}

ClosedForm unit_disc(double undecided) {
  return [undecided](Real a, Real b) { return object_by_sign(1 - square_root(16 * a * a + 9 * b * b), undecided); };
}

ClosedForm double_cone(bool from_above) {
  return [from_above](Real a, Real b) {
    const Real x = 4 * a, y = 3 * b;
    return object_by_sign(1 - (from_above ? square_root(x * x + y * y) : magnitude(x) + magnitude(y)), 1e-6);
  };
}

ClosedForm bent_tube() {
  return [](Real a, Real b) {
    static constexpr std::array<Point, 5> kJoints{{{-1.4, -0.9}, {-0.7, 0.8}, {-0.6, -0.8}, {0.9, -0.8}, {1.2, 0.9}}};
    Real nearest = 100;
    for (std::size_t i = 0; i + 1 < kJoints.size(); ++i) {
      nearest = std::min(nearest, distance_to_segment(4 * a, 3 * b, kJoints[i], kJoints[i + 1]));
    }
    return object_by_sign(Real{0.25} - nearest, 1e-6);
  };
}

}  // namespace lute::extreme
