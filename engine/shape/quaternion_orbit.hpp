// Orbits of z -> z² + c, or z³ + c, of quaternions, of which only lengths are wanted.
//
// The image of a quaternion with the real part x and the vector part v has the real part x² - v·v + c (x³ - 3x v·v + c) and the vector part
// kv + C, where k = 2x (3x² - v·v) and C is the constant's. Lengths need no more of v than v·v and 2v·C, which become k² v·v + k 2v·C + C·C
// and k 2v·C + 2C·C: three numbers instead of four, and fewer steps that wait for each other. An own derivation;
// patch_and_field_test.cpp compares it with the product written out.
#pragma once

#include <cstddef>

#include "engine/math/vec.hpp"

namespace lute {

struct QuaternionLengths {
  double real, square, twice;  // x, v·v, 2v·C
};

class QuaternionOrbit {
 public:
  // It leaves where a squared length exceeds `escape`; `steps` lengths are asked.
  QuaternionOrbit(const dvec4& constant, bool cube, std::size_t steps, double escape)
      : real_(constant.x), vector_(constant.y, constant.z, constant.w), square_(glm::dot(vector_, vector_)), escape_(escape), steps_(steps),
        cube_(cube) {}

  const dvec3& constant_vector() const { return vector_; }
  QuaternionLengths lengths(const dvec4& z) const {
    const dvec3 v(z.y, z.z, z.w);
    return {z.x, glm::dot(v, v), 2 * glm::dot(v, vector_)};
  }

  // The step, from 1, before which the orbit has left, or 0 if it never does; the squared length there, and the product of those before.
  std::size_t escape(const QuaternionLengths& z, double& norm, double& product) const {
    return cube_ ? escape_of<true>(z, norm, product) : escape_of<false>(z, norm, product);
  }
  bool stays(const QuaternionLengths& z) const {
    double norm, product;
    return escape(z, norm, product) == 0;
  }

 private:
  template <bool kCube>
  std::size_t escape_of(const QuaternionLengths& start, double& norm, double& product) const {
    const double limit = escape_, real = real_, square = square_;
    double x = start.real, vv = start.square, twice = start.twice, lengths = 1;
    for (std::size_t i = 1; i <= steps_; ++i) {
      const double x2 = x * x, size = x2 + vv;
      if (size > limit) {
        norm = size;
        product = lengths;
        return i;
      }
      lengths *= size;
      const double k = kCube ? 3 * x2 - vv : 2 * x;
      x = (kCube ? x * (x2 - 3 * vv) : x2 - vv) + real;
      vv = k * (k * vv + twice) + square;
      twice = k * twice + 2 * square;
    }
    return 0;
  }

  double real_;
  dvec3 vector_;
  double square_, escape_;
  std::size_t steps_;
  bool cube_;
};

// What of it the points of a line have.
class QuaternionLengthsAlong {
 public:
  // The quaternion at a depth, and how it changes along the line.
  QuaternionLengthsAlong(const QuaternionOrbit& orbit, const dvec4& z, const dvec4& direction, double depth) {
    // About the depth where v is shortest, so that no digits of its length are lost there.
    const dvec3 d(direction.y, direction.z, direction.w), v(z.y, z.z, z.w);
    slope_of_square_ = glm::dot(d, d);
    const double shift = slope_of_square_ > 0 ? -glm::dot(v, d) / slope_of_square_ : 0;
    middle_ = depth + shift;
    at_middle_ = orbit.lengths(z + shift * direction);
    real_slope_ = direction.x;
    slope_of_twice_ = 2 * glm::dot(d, orbit.constant_vector());
  }
  QuaternionLengths at(double depth) const {
    const double u = depth - middle_;
    return {at_middle_.real + u * real_slope_, at_middle_.square + u * u * slope_of_square_, at_middle_.twice + u * slope_of_twice_};
  }

 private:
  double middle_, real_slope_, slope_of_square_, slope_of_twice_;
  QuaternionLengths at_middle_;
};

}  // namespace lute
