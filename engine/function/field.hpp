// What the formulas of the internal functions share (specification chapter 21 §11.5). They are written once, for numbers and for ranges of
// numbers (engine/function/enclosure.hpp).
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/function/enclosure.hpp"
#include "engine/math/vec.hpp"

namespace lute::field {

using std::cos;
using std::exp;
using std::fabs;
using std::max;
using std::min;
using std::pow;
using std::sin;
using std::sqrt;

// x, y, z and their squares.
template <class T>
struct Point {
  T x, y, z, X, Y, Z, R;
  explicit Point(const T* a) : x(a[0]), y(a[1]), z(a[2]), X(x * x), Y(y * y), Z(z * z), R(X + Y + Z) {}
};

template <class T>
T limit(const T& v) {
  return min(T(10.0), max(v, T(-10.0)));
}
template <class T>
T limit(const T& v, const T& l) {
  return min(l, max(v, -l));
}
template <class T>
T sq(const T& v) {
  return v * v;
}
template <class T>
T cube(const T& v) {
  return v * v * v;
}

// A parameter that decides which formula counts: of a range, not a number unless it is one.
inline double decided(double v) { return v; }
inline double decided(const Enclosure& v) { return v.is_point() ? v.lo : std::nan(""); }

// C remainder made non-negative.
inline double positive_mod(double v, double m) {
  const double r = std::fmod(v, m);
  return r < 0 ? r + m : r;
}

// The switch between a curve in the plane and its surface of revolution: parameters S, d, angle in degrees.
template <class T>
Point<T> plane_or_revolved(const T* a, const T& s, const T& d, const T& degrees) {
  Point<T> p(a);
  if (decided(s) <= 0) return p;
  const T rho = sqrt(p.X + p.Z) - d;
  const double angle = radians(decided(degrees));
  T x = rho, y = p.y;
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
template <class T>
T cross_section(T a, T b, const T& shape, const T& degrees) {
  const double s = decided(shape), turn = decided(degrees);
  if (s == 1) return sqrt(a * a + b * b);
  if (turn != 0) {
    const double angle = radians(turn);
    const T turned = a * std::cos(angle) - b * std::sin(angle);
    b = a * std::sin(angle) + b * std::cos(angle);
    a = turned;
  }
  if (s == 0) return max(fabs(a), fabs(b));
  return pow(pow(fabs(a), T(2 / s)) + pow(fabs(b), T(2 / s)), T(s / 2));
}

// Three crossed ellipsoids as fields.
template <class T>
struct Ellipsoids {
  T e1, e2, e3;
  Ellipsoids(const Point<T>& p, const T& e, const T& i)
      : e1(exp(-i * (e * p.X + e * p.Y + p.Z))), e2(exp(-i * (e * p.X + p.Y + e * p.Z))), e3(exp(-i * (p.X + e * p.Y + e * p.Z))) {}
};

}  // namespace lute::field
