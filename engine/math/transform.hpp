// Affine transformations with their inverse, as `translate`, `rotate`, `scale`, `matrix` and `transform` build them.
//
// Points are columns here (p' = linear * p + translation); the scene language writes them as rows, which is the same numbers
// transposed: the image of x is the first column of `linear`. Angles are degrees, rotations left-handed, about x, then y, then z
// (specification chapters 10 §8.3 and 11 §13). `kinds` and `flips` remember what the transformation is made of, because some shapes
// keep their analytic form under some kinds only (chapter 20 §5), and fold into their own numbers what is written before the others.
#pragma once

#include <cstdint>

#include "engine/math/aabb.hpp"
#include "engine/math/ray.hpp"
#include "engine/math/vec.hpp"

namespace lute {

struct Transform {
  enum Kind : std::uint8_t {
    kTranslate = 1,
    kRotate = 2,
    kUniformScale = 4,  // all three factors equal
    kScale = 8,         // factors that differ
    kMatrix = 16        // `matrix<...>` or `transform{...}`
  };

  dmat3 linear{1.0};
  dvec3 translation{0};
  dmat3 inverse_linear{1.0};
  dvec3 inverse_translation{0};
  std::uint8_t kinds = 0;  // union of Kind; 0: identity
  std::uint8_t flips = 0;  // bit a: the scales before the first rotation or matrix turn axis a round

  static Transform translate(const dvec3& offset);
  static Transform rotate(const dvec3& degrees);
  static Transform scale(const dvec3& factors);  // no factor may be 0
  // `columns` are the images of x, y, z. A singular matrix yields an inverse full of infinities or NaN, as the reference has it;
  // see invertible().
  static Transform matrix(const dmat3& columns, const dvec3& offset);

  bool identity() const { return kinds == 0; }
  bool invertible() const;

  // First this, then `next` (the order in which modifiers are written).
  Transform then(const Transform& next) const;
  Transform inverse() const;
  Transform as_matrix() const;  // the same as one `matrix`: nothing of it is folded

  dvec3 point(const dvec3& p) const { return linear * p + translation; }
  dvec3 direction(const dvec3& d) const { return linear * d; }
  dvec3 inverse_point(const dvec3& p) const { return inverse_linear * p + inverse_translation; }
  dvec3 inverse_direction(const dvec3& d) const { return inverse_linear * d; }
  dvec3 normal(const dvec3& n) const;  // inverse transpose, not normalised
  dvec3 inverse_normal(const dvec3& n) const;
  Ray inverse_ray(const Ray& ray) const { return {inverse_point(ray.origin), inverse_direction(ray.direction)}; }
  Aabb box(const Aabb& b) const;  // box around the transformed box; infinite stays infinite
};

}  // namespace lute
