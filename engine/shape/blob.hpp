// blob { [threshold T] sphere { <c>, r, [strength] s } cylinder { <a>, <b>, r, [strength] s } ... [sturm] [hierarchy] }
//
//   blob { threshold 0.6 sphere { <-0.75, 0, 0>, 1, 1 } sphere { <0.75, 0, 0>, 1, 1 } pigment { rgb 1 } }
//
// threshold (default 1): the density of the surface; strength may be negative. Components have transformations and textures of
// their own; where any has, the textures of all components at a point are mixed by their densities.
//
// A component of radius r has density s (1 - ρ²/r²)² at the distance ρ < r from its centre or axis; a cylinder has half a sphere at
// each end. Along the ray every component is a quartic within the interval where the ray is in its reach; between two ends of such
// intervals their sum is one quartic, solved when its Bernstein coefficients do not all have one sign. Each quartic is set up about
// the beginning of its interval. A hit is at least 0.01 away: so the reference has it (§5.10), authors see it.
// sturm is accepted and changes nothing: no root is lost without it.
// Source: specification chapter 20 §5.10. Surfaces of equal density: J. F. Blinn, A Generalization of Algebraic Surface Drawing, 1982. The
// ray's way cut where components begin and end, with Bernstein coefficients between: T. Nishita, E. Nakamae, A Method for Displaying
// Metaballs by using Bézier Clipping, 1994; roots: root_walk.hpp.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/memory/shared_transform.hpp"
#include "engine/shape/shape.hpp"

namespace lute {

struct Texture;  // engine/scene/texture.hpp

struct BlobComponent {
  enum class Kind : std::uint8_t { kSphere, kCylinder };
  Kind kind = Kind::kSphere;
  dvec3 center{0};      // of a sphere, or the base of a cylinder
  dvec3 apex{0, 1, 0};  // of a cylinder
  double radius = 1, strength = 1;
  SharedTransform transform;               // of the component within the blob
  std::shared_ptr<const Texture> texture;  // null: that of the blob
  SharedTransform texture_placement;       // within the blob; the blob's own transformation is added when it is built
};

struct Blob {
  static constexpr std::string_view kKeyword = "blob";
  double threshold = 1;
  std::vector<BlobComponent> components;
  bool sturm = false, hierarchy = true;

  // TextureWeight::index is the number of the component.
  bool mixes_textures() const;
};

std::unique_ptr<Shape> build(const Blob& blob, const Transform& to_world, BuildContext& context);

}  // namespace lute
