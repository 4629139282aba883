// Walks a scene's description once and notes what occurs, and where it first does.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "engine/scene/scene.hpp"

namespace lute {

// The first place where something was seen; `count` in all.
struct Seen {
  SourceLocation where;
  long count = 0;
  explicit operator bool() const { return count > 0; }
};

class SceneSurvey {
 public:
  explicit SceneSurvey(const Scene& scene);

  Seen translucent, reflecting, fresnel, conserve_energy, normal_pattern, phong, specular, iridescent, random_diffuse, patterned_texture,
      layered_texture, uv_pattern, subsurface, refracting, dispersing, fading, caustics, object_media, hollow, clipped, csg, group,
      non_opaque;
  Seen light, shadow_light, projecting, fading_light, fog_light;
  std::map<std::string, Seen> light_kinds, shapes, patterns;

 private:
  void object(const Object& o);
  void light_source(const LightSource& l);
  void interior(const Interior& i);
  void texture(const Texture& t);
  void layer(const TextureLayer& l, SourceLocation where);
  void finish(const Finish& f, SourceLocation where);
  void pigment(const Pigment& p);
  void normal(const Normal& n);
  void body(const PatternBody& b, SourceLocation where);
  bool first_visit(const void* value) { return visited_.insert(value).second; }

  std::set<const void*> visited_;
};

// True if no colour of the pigment lets light through, and it is everywhere: an image shown once is not.
bool certainly_opaque(const Pigment& p);
bool certainly_opaque(const Texture& t);

// False: written so that it shows nowhere.
bool has_effect(const Fog& fog);
bool has_effect(const Rainbow& rainbow);

}  // namespace lute
