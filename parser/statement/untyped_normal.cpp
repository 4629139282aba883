#include "parser/statement/untyped_normal.hpp"

#include <algorithm>
#include <type_traits>

#include "parser/statement/object_edit.hpp"

namespace lute {
namespace {

bool is_untyped(const NormalPtr& normal) {
  if (normal == nullptr) return false;
  if (std::holds_alternative<NoPattern>(normal->body.pattern)) return true;
  const auto* map = std::get_if<NormalMap>(&normal->map);
  return map != nullptr && std::ranges::any_of(map->entries, [](const auto& entry) { return is_untyped(entry.value); });
}

bool in_texture(const TexturePtr& texture) {
  if (texture == nullptr) return false;
  if (const auto* layers = std::get_if<std::vector<TextureLayer>>(&texture->content))
    return std::ranges::any_of(*layers, [](const TextureLayer& layer) { return is_untyped(layer.normal); });
  const auto& entries = std::get<PatternedTexture>(texture->content).map.entries;
  return std::ranges::any_of(entries, [](const auto& entry) { return in_texture(entry.value); });
}

bool in_parts(const AnyShape& any) {
  return any.visit(
      [](const auto& shape) {
        using Description = std::decay_t<decltype(shape)>;
        if constexpr (std::is_same_v<Description, Mesh>)
          return std::ranges::any_of(shape.data->textures, in_texture);
        else if constexpr (std::is_same_v<Description, Blob>)
          return std::ranges::any_of(shape.components, [](const auto& component) { return in_texture(component.texture); });
        else
          return false;
      });
}

bool in_object(const Object& object, bool textured, bool untyped_default) {
  if (in_texture(object.texture.texture) || in_texture(object.extras->interior_texture.texture)) return true;
  textured = textured || object.texture.texture != nullptr;
  if (const Csg* csg = object.csg())
    return std::ranges::any_of(csg->children, [&](const ObjectPtr& child) { return in_object(*child, textured, untyped_default); });
  if (is_light(object)) return false;
  return (untyped_default && !textured) || in_parts(*object.shape());
}

}  // namespace

bool has_untyped_normal(const Object& object, const Texture& default_texture) {
  const auto& layers = std::get<std::vector<TextureLayer>>(default_texture.content);
  return in_object(object, false, is_untyped(layers.front().normal));
}

}  // namespace lute
