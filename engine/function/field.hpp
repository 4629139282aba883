// What the formulas of the internal functions share (specification chapter 21 §11.5).
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/math/vec.hpp"

namespace lute::field {

// x, y, z and their squares.
struct Point {
  double x, y, z, X, Y, Z, R;
  explicit Point(const double* a)
      : x(a[0]), y(a[1]), z(a[2]), X(x * x), Y(y * y), Z(z * z), R(X + Y + Z) {}
};

inline double limit(double v) { return std::min(10.0, std::max(v, -10.0)); }
inline double limit(double v, double l) { return std::min(l, std::max(v, -l)); }
inline double sq(double v) { return v * v; }
inline double cube(double v) { return v * v * v; }

// C remainder made non-negative.
inline double positive_mod(double v, double m) {
  const double r = std::fmod(v, m);
  return r < 0 ? r + m : r;
}

// The switch between a curve in the plane and its surface of revolution: parameters S, d, angle in degrees.
inline Point plane_or_revolved(const double* a, double s, double d, double degrees) {
  Point p(a);
  if (!(s > 0)) return p;
  const double rho = std::sqrt(p.X + p.Z) - d;
  const double angle = radians(degrees);
  double x = rho, y = p.y;
  if (angle != 0) {
    x = rho * std::cos(angle) - p.y * std::sin(angle);
    y = rho * std::sin(angle) + p.y * std::cos(angle);
  }
  p.x = x;
  p.y = y;
  p.X = x * x;
  p.Y = y * y;
  return p;
}

// Distance of (a, b) from the centre of a cross-section: s = 1 circle, 0 square, else superellipse, turned by `degrees`.
inline double cross_section(double a, double b, double s, double degrees) {
  if (s == 1) return std::sqrt(a * a + b * b);
  if (degrees != 0) {
    const double angle = radians(degrees);
    const double turned = a * std::cos(angle) - b * std::sin(angle);
    b = a * std::sin(angle) + b * std::cos(angle);
    a = turned;
  }
  if (s == 0) return std::max(std::fabs(a), std::fabs(b));
  return std::pow(std::pow(std::fabs(a), 2 / s) + std::pow(std::fabs(b), 2 / s), s / 2);
}

// Three crossed ellipsoids as fields.
struct Ellipsoids {
  double e1, e2, e3;
  Ellipsoids(const Point& p, double e, double i)
      : e1(std::exp(-i * (e * p.X + e * p.Y + p.Z))),
        e2(std::exp(-i * (e * p.X + p.Y + e * p.Z))),
        e3(std::exp(-i * (p.X + e * p.Y + e * p.Z))) {}
};

}  // namespace lute::field
