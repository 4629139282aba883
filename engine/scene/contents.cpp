#include "engine/scene/contents.hpp"

#include <algorithm>
#include <string_view>
#include <type_traits>

#include "engine/function/function.hpp"
#include "engine/scene/media.hpp"

namespace lute {
namespace {

void deepen(std::uint32_t& depth, std::uint32_t part) { depth = std::max(depth, part); }

template <class T>
std::uint32_t deepest_entry(const BlendMap<T>& map) {
  std::uint32_t depth = 0;
  for (const auto& entry : map.entries)
    if (entry.value != nullptr) deepen(depth, entry.value->depth);
  return depth;
}

void join(Contents& whole, const Contents& part) {
  deepen(whole.depth, part.depth);
  whole.leaves += part.leaves;
  whole.textured = whole.textured || part.textured;
  whole.patches = whole.patches || part.patches;
  whole.media_densities = whole.media_densities || part.media_densities;
}

bool is_patch(const AnyShape& shape) {
  return shape.visit([](const auto& s) {
    if constexpr (requires { s.inside_vector; }) return s.inside_vector == dvec3(0);
    constexpr std::string_view keyword = std::decay_t<decltype(s)>::kKeyword;
    return keyword == "triangle" || keyword == "smooth_triangle" || keyword == "bicubic_patch" || keyword == "polygon" ||
           keyword == "parametric";
  });
}

// Functions and textures that belong to the shape itself.
std::uint32_t depth_of(const AnyShape& shape) {
  std::uint32_t depth = 0;
  shape.visit([&](const auto& s) {
    if constexpr (requires { s.function->depth(); }) deepen(depth, s.function->depth());
    if constexpr (requires { s.functions[0]->depth(); })
      for (const auto& function : s.functions) deepen(depth, function->depth());
    if constexpr (requires { s.data->textures; })
      for (const TexturePtr& texture : s.data->textures)
        if (texture != nullptr) deepen(depth, texture->depth);
    if constexpr (requires { s.components[0].texture->depth; })
      for (const auto& component : s.components)
        if (component.texture != nullptr) deepen(depth, component.texture->depth);
  });
  return depth;
}

void add_interior(Contents& contents, const Interior& interior) {
  for (const auto& media : interior.media) {
    for (const PigmentPtr& density : media->densities) {
      deepen(contents.depth, density->depth);
      contents.media_densities = true;
    }
  }
}

// What a light shines through or looks like is no part of the object around it.
void add_light(Contents& contents, const LightSource& light) {
  for (const auto& attached : {light.looks_like, light.projected_through}) {
    if (attached == nullptr) continue;
    const Contents part = contents_of(*attached);
    deepen(contents.depth, part.depth);
    contents.leaves += part.leaves;
  }
}

}  // namespace

std::uint32_t depth_of(const PatternBody& body) {
  const auto* pattern = std::get_if<AnyPattern>(&body.pattern);
  if (pattern == nullptr) return 0;
  return std::visit(
      [](const auto& p) -> std::uint32_t {
        if constexpr (requires { p.object; }) return contents_of(*p.object).depth;
        else if constexpr (requires { p.pigment; }) return p.pigment->depth;
        else if constexpr (requires { p.function; }) return p.function->depth();
        else return 0;
      },
      *pattern);
}

std::uint32_t depth_of(const Pigment& pigment) {
  std::uint32_t depth = depth_of(pigment.body);
  if (const auto* map = std::get_if<PigmentMap>(&pigment.map)) deepen(depth, deepest_entry(*map));
  return depth + 1;
}

std::uint32_t depth_of(const Normal& normal) {
  std::uint32_t depth = depth_of(normal.body);
  if (const auto* map = std::get_if<NormalMap>(&normal.map)) deepen(depth, deepest_entry(*map));
  return depth + 1;
}

std::uint32_t depth_of(const Texture& texture) {
  std::uint32_t depth = 0;
  if (const auto* layers = std::get_if<std::vector<TextureLayer>>(&texture.content)) {
    for (const TextureLayer& layer : *layers) {
      deepen(depth, layer.pigment->depth);
      if (layer.normal != nullptr) deepen(depth, layer.normal->depth);
    }
  } else {
    const auto& patterned = std::get<PatternedTexture>(texture.content);
    depth = std::max(depth_of(patterned.body), deepest_entry(patterned.map));
  }
  return depth + 1;
}

Contents contents_of(const std::vector<ObjectPtr>& objects) {
  Contents contents;
  for (const ObjectPtr& object : objects) join(contents, contents_of(*object));
  return contents;
}

Contents contents_of(const Object& object) {
  Contents contents;
  if (const Csg* csg = object.csg()) {
    contents = csg->contents;
  } else {
    contents.leaves = 1;
    if (const AnyShape* shape = object.shape()) contents.depth = depth_of(*shape);
    else add_light(contents, *object.light());
  }
  contents.patches = is_patch(object);
  if (object.texture.texture != nullptr) {
    contents.textured = true;
    deepen(contents.depth, object.texture.texture->depth);
  }
  if (!object.extras.is_default()) {
    const ObjectExtras& extras = *object.extras;
    deepen(contents.depth, extras.limits.depth);
    contents.leaves += extras.limits.leaves;
    if (extras.interior_texture.texture != nullptr) deepen(contents.depth, extras.interior_texture.texture->depth);
    if (extras.interior != nullptr) add_interior(contents, *extras.interior);
  }
  ++contents.depth;
  return contents;
}

bool is_patch(const Object& object) {
  if (const Csg* csg = object.csg()) return csg->operation != CsgOperation::kLightGroup && csg->contents.patches;
  if (const LightSource* light = object.light()) return light->looks_like == nullptr || is_patch(*light->looks_like);
  return is_patch(*object.shape());
}

}  // namespace lute
