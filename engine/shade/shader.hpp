// Whitted's recursion for one camera ray: trace finds what a ray meets, shade says what it looks like, and traces further rays.
// Source: specification chapter 40; the numbers behind the names are sections of it.
//
// The parts of the class are in files of their own: trace.cpp (§3), surface.cpp (§4), layers.cpp (§5), direct_light.cpp (§7),
// highlight.cpp (§7), reflection.cpp (§8), refraction.cpp (§9), shadow.cpp and area_shadow.cpp (§10.4, §11), sky.cpp (§12).
#pragma once

#include <array>
#include <span>

#include "engine/build/built_scene.hpp"
#include "engine/plan/render_plan.hpp"
#include "engine/shade/interior_list.hpp"
#include "engine/shade/scratch.hpp"
#include "engine/shade/tracer.hpp"

namespace lute {

inline constexpr double kMinimumDepth = 1e-4;      // nearer hits of the surface that a ray leaves are ignored
inline constexpr double kNearestDepth = 1e-10;     // the same for what touches that surface behind it, and for the camera
inline constexpr double kShadowTolerance = 1e-3;   // a shadow ray keeps this distance from both of its ends
inline constexpr double kDepthOfMiss = 2e10;       // for fog and rainbow, where nothing is hit
inline constexpr float kColorEpsilon = 1e-10f;

inline bool nearly_black(Rgb c) {
  return std::abs(c.r) < kColorEpsilon && std::abs(c.g) < kColorEpsilon && std::abs(c.b) < kColorEpsilon;
}

struct TracedRay {
  Ray ray;
  RayKind kind;
  bool continues = false;      // passes straight on: no level of its own
  bool monochromatic = false;  // one band of a dispersed ray
  double wavelength = 0;       // nm, of that band
  double reach = kDepthOfMiss;  // of a mesh camera's ray: where it ends
  InteriorList interiors;
  const Leaf* from = nullptr;    // whose surface it leaves; null: the camera

  bool hollow() const;  // §3: every interior it is in is hollow
};

// The spaces around a texture, outermost first: that of the object's texture, then the pattern of each enclosing
// texture. Normals are carried through them.
struct TextureSpace {
  const TextureSpace* outer = nullptr;
  const Transform* to_world = nullptr;  // from the space of the object's texture
  const CompiledPattern* pattern = nullptr;
  bool bump_scale = true;  // of the texture of that pattern
};

class Shader {
 public:
  Shader(const BuiltScene& scene, const RenderPlan& plan, TraceContext& context)
      : scene_(scene), plan_(plan), settings_(scene.settings), context_(context), scratch_(*context.scratch) {
    scratch_.last_blockers.resize(scene.lights.size());
  }

  Color trace(const TracedRay& ray, float weight);

 private:
  // A hit while it is being shaded.
  struct Surface {
    const TracedRay& in;
    const Hit& hit;
    const Leaf& leaf;
    float weight;
    SurfaceContext context;             // raw normal, facing the ray; uv; the normal that patterns see
    ScratchBlock<LightAtPoint>* lights = nullptr;
  };

  // One layer of a texture while light falls on it.
  struct LitLayer {
    const Finish& finish;
    Color pigment;
    float opacity;
    dvec3 normal;
  };

  struct Transmitted {
    Color color;
    bool total_reflection = false;
  };

  // trace.cpp
  Color miss(const TracedRay& ray) const;
  void add_volume_effects(const TracedRay& ray, double depth, Color& color);

  // surface.cpp
  Color shade(const TracedRay& ray, const Hit& hit, float weight);
  template <class Evaluate>
  void for_each_texture(const Hit& hit, const Leaf& leaf, bool from_inside, Evaluate&& evaluate);
  static SurfaceContext face_ray(const Hit& hit, const Ray& ray, bool wants_uv, bool& from_inside);
  static dvec3 texture_point(const PlacedTexture& texture, const Leaf& leaf, const Hit& hit, const SurfaceContext& context);
  Color texture_color(Surface& surface, const CompiledTexture& texture, const dvec3& point, const TextureSpace* space);
  static dvec3 perturbed(const CompiledNormal& normal, const dvec3& point, const TextureSpace* space, SurfaceContext& context);

  // layers.cpp
  Color layers_color(Surface& surface, const CompiledTexture& texture, const dvec3& point, const TextureSpace* space);
  Rgb own_light(Surface& surface, const LitLayer& layer);
  // True: the light was totally reflected.
  bool add_transmission(Surface& surface, const Finish& top_finish, const dvec3& top_normal, Rgb filter,
                        float translucency, bool pigment_found, Color& color);
  void add_reflections(Surface& surface, const dvec3& top_normal, bool total_reflection, ScratchBlock<ReflectingLayer>& layers,
                       Color& color);

  // direct_light.cpp
  using Lights = std::span<const BuiltLight* const>;
  std::array<Lights, 2> lights_of(const Leaf& leaf) const;
  std::size_t light_count(const Leaf& leaf) const;
  Rgb direct_light(Surface& surface, const LitLayer& layer);
  Rgb light_from(const Surface& surface, const LitLayer& layer, const BuiltLight& source, LightAtPoint& known);
  Rgb after_shadows(const Surface& surface, const BuiltLight& light, LightAtPoint& known);
  Rgb area_illumination(const Surface& surface, const LitLayer& layer, const BuiltLight& light, const dvec3& to_center, Rgb color);
  Rgb scattered(const Surface& surface, const LitLayer& layer, const BuiltLight& light, const dvec3& to_light, Rgb color,
                bool backside);
  Rgb diffused(const LitLayer& layer, const dvec3& to_light, Rgb color, bool backside);
  Rgb diffused_and_shining(const Surface& surface, const LitLayer& layer, const BuiltLight& light, const dvec3& to_light,
                           Rgb color, bool backside);
  Rgb highlights(const Surface& surface, const LitLayer& layer, const dvec3& to_light, Rgb color) const;
  Rgb iridescence(const Finish& finish, const dvec3& point, double cos_light, double cos_view) const;

  // shadow.cpp
  Rgb shadowed(const Surface& surface, const BuiltLight& light, const LightPath& path, Rgb color);
  Rgb filtered(const Surface& surface, const BuiltLight& light, const LightPath& path, double reach, Rgb color);
  Rgb shadow_filter(const Hit& hit, const Ray& ray, const InteriorList& interiors);
  Rgb texture_filter(const CompiledTexture& texture, const dvec3& point, const TextureSpace* space, const Leaf& leaf,
                     const dvec3& to_light, SurfaceContext& context);
  bool aperture_end(const BuiltLight& light, const Surface& surface, const LightPath& path, double& reach) const;

  // area_shadow.cpp
  struct AreaRegion {
    int u1, v1, u2, v2, level;
  };
  struct AreaGrid;
  Rgb area_shadow(const Surface& surface, const BuiltLight& light, const dvec3& to_center, Rgb color);
  Rgb area_region(AreaGrid& grid, const AreaRegion& region);
  Rgb area_sample_light(AreaGrid& grid, int u, int v);

  // reflection.cpp
  Rgb reflectivity(const Surface& surface, const LitLayer& layer, float layer_weight, float& ray_weight) const;
  double relative_index(const Surface& surface) const;
  Color reflected(const Surface& surface, const Finish& finish, const dvec3& normal, float weight);

  // refraction.cpp
  struct Crossing {
    double index = 1, dispersion = 1;
    int samples = 7;
    InteriorList interiors;
  };
  Crossing cross(const Surface& surface) const;
  Transmitted transmitted(const Surface& surface, const Finish& top_finish, const dvec3& top_normal, float weight);
  Transmitted bent(const Surface& surface, const Finish& top_finish, const dvec3& top_normal, TracedRay& out,
                   double index, float weight);
  Color dispersed(const Surface& surface, const Finish& top_finish, const dvec3& top_normal, TracedRay& out,
                  const Crossing& crossing, float weight);
  static Rgb distance_fade(const BuiltInterior& interior, double length);

  const BuiltScene& scene_;
  const RenderPlan& plan_;
  const ShadingSettings& settings_;
  TraceContext& context_;
  TraceScratch& scratch_;
  int level_ = 0;         // n of §3
  int depth_ = 0;         // of the recursion, continued rays included
  std::uint64_t rays_ = 0;
};

// sky.cpp: what a ray sees that meets nothing (§12). `with_alpha`: alpha is being produced for this ray.
Color sky_color(const BuiltScene& scene, const dvec3& direction, bool with_alpha);

// highlight.cpp: how much of a metal's own colour a reflection takes at an angle with cosine c (§7, §8).
Rgb metallic_tint(Rgb pigment, float metallic, double c);

// The mirror direction, kept on the outer side of the raw normal (§8).
dvec3 mirror_direction(const dvec3& direction, const dvec3& normal, const dvec3& raw_normal);

// dispersion.cpp: the colour of a band of a dispersed ray, times the number of bands (§9.3).
Rgb band_color(double wavelength, int bands);
double index_at(double index, double dispersion, double wavelength);

// The textures of a hit: those of the shape's parts, of the solids that contain a cut, or one. Calls
// evaluate(const PlacedTexture&, float weight); not at all for a cut surface that no texture covers.
template <class Evaluate>
void Shader::for_each_texture(const Hit& hit, const Leaf& leaf, bool from_inside, Evaluate&& evaluate) {
  const bool has_parts = leaf.has_part_textures();
  if (!has_parts && (leaf.texture.texture != nullptr || hit.cutaway == nullptr)) {
    const PlacedTexture& texture = leaf.texture_of_side(from_inside);
    if (texture.texture != nullptr) evaluate(texture, 1.0f);
    return;
  }
  if (!has_parts) {
    CsgSolid::CutawayShares& shares = scratch_.shares;
    const std::size_t first = shares.size();
    hit.cutaway->cutaway_shares(hit.point, *hit.leaf, shares);
    const std::size_t end = shares.size();
    for (std::size_t i = first; i < end; ++i) {
      const auto [part, share] = shares[i];
      evaluate(part->texture, static_cast<float>(share));
    }
    shares.resize(first);
    return;
  }
  const std::vector<PlacedTexture>& parts = leaf.further->parts;
  std::vector<TextureWeight>& weights = scratch_.weights;
  const std::size_t first = weights.size();
  leaf.shape->textures(hit.shape_hit, hit.point, weights);
  const std::size_t end = weights.size();
  for (std::size_t i = first; i < end; ++i) {
    const TextureWeight part = weights[i];
    const bool own = part.index < parts.size() && parts[part.index].texture != nullptr;
    const PlacedTexture& texture = own ? parts[part.index] : leaf.texture_of_side(from_inside);
    if (texture.texture != nullptr) evaluate(texture, part.weight);
  }
  weights.resize(first);
}

}  // namespace lute
