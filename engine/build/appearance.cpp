// Textures, interiors and flags: what comes down from the parents, and the default where nothing does.
// Source: specification chapters 11 §11.2, §14.1 and 20 §6.4-6.5, §8.2.
#include <algorithm>
#include <type_traits>

#include "engine/build/scene_builder.hpp"

namespace lute {

bool holds_texture(const Object& object) {
  if (object.texture.texture != nullptr) return true;
  const Csg* csg = object.csg();
  return csg != nullptr && std::ranges::any_of(csg->children, [](const ObjectPtr& child) { return holds_texture(*child); });
}

SceneBuilder::Context SceneBuilder::resolve(const Object& object, const Context& parent) {
  Context own = parent;
  own.parent_to_world = parent.to_world;
  own.to_world = object.transform.then(parent.to_world);
  own.inverted = parent.inverted != object.inverse;
  own.visibility.no_image |= object.no_image;
  own.visibility.no_reflection |= object.no_reflection;
  own.visibility.no_radiosity |= object.no_radiosity;
  own.visibility.no_shadow |= object.no_shadow;
  own.double_illuminate |= object.double_illuminate;

  const Csg* csg = object.csg();
  if (csg != nullptr) own.cutaway |= csg->cutaway_textures;
  own.declared |= object.declared;
  if (csg != nullptr && csg->operation == CsgOperation::kLightGroup) enter_light_group(object, *csg, parent, own);

  if (object.light() != nullptr) {
    pass_textures(object, parent, own);
    return own;
  }
  // A shape keeps its own `hollow`; a combination's word reaches the shapes only where no outer one has spoken (§8.2).
  if (csg == nullptr ? object.hollow.has_value() : !parent.hollow) own.hollow = object.hollow;
  pass_textures(object, parent, own);
  const InteriorPtr& interior = object.extras->interior;
  if (own.interior == nullptr || interior != nullptr) own.interior = new_interior(interior);
  settle_interior(object, own);
  return own;
}

void SceneBuilder::pass_textures(const Object& object, const Context& parent, Context& own) {
  // A texture of a uv mapped object is not moved with the object, nor by the parents.
  const auto placed = [&](const TextureOnObject& t) {
    if (object.uv_mapping) return Placed{t.texture, t.placement};
    return Placed{t.texture, t.placement.shares(object.transform) ? own.to_world : t.placement.then(parent.to_world)};
  };
  const bool own_texture = object.texture.texture != nullptr;
  const TextureOnObject& interior_texture = object.extras->interior_texture;
  const bool own_interior_texture = interior_texture.texture != nullptr;
  own.uv_mapping = object.uv_mapping || (parent.uv_mapping && (!own_texture || !own_interior_texture));
  if (own_texture) own.texture = placed(object.texture);
  if (own_interior_texture) own.interior_texture = placed(interior_texture);

  const bool light = object.light() != nullptr;
  if (own.texture.texture == nullptr && !light && !parent.stays_untextured && !holds_texture(object))
    own.texture = {default_texture_ != nullptr ? default_texture_ : built_in_texture_, {}};
}

TexturePtr SceneBuilder::built_in_texture() {
  auto built_in = std::make_shared<Texture>();
  built_in->content = std::vector<TextureLayer>{{std::make_shared<Pigment>(), nullptr, std::make_shared<Finish>()}};
  return built_in;
}

BuiltInterior* SceneBuilder::new_interior(const InteriorPtr& description) {
  BuiltInterior& interior = built_.interiors.emplace_back();
  if (description == nullptr) return &interior;
  Shared<InteriorProperties>& shared = interior_properties_[description.get()];
  if (shared.is_default()) {
    const Interior& d = *description;
    InteriorProperties& p = shared.edit();
    if (d.ior != 0) {
      p.ior = d.ior;
      p.dispersion = d.dispersion;
    }
    p.dispersion_samples = d.dispersion_samples;
    p.caustics = d.caustics;
    p.fade_distance = d.fade_distance * static_cast<float>(built_.scale);
    p.fade_power = d.fade_power;
    p.fade_color = d.fade_color;
    p.refraction = d.refraction;
    p.media = d.media;
    p.where = d.where;
  }
  interior.properties = shared;
  return &interior;
}

// The interior may be shared by the parts of a combination: the last one to be settled decides.
void SceneBuilder::settle_interior(const Object& object, const Context& own) {
  BuiltInterior& interior = *own.interior;
  const bool combination = object.csg() != nullptr;
  interior.hollow = combination ? object.hollow.value_or(false) : own.hollow.value_or(false);
  if (own.texture.texture == nullptr) return;
  const auto* layers = std::get_if<std::vector<TextureLayer>>(&own.texture.texture->content);
  if (layers == nullptr || layers->empty()) return;
  const Finish& finish = *layers->back().finish;
  if (finish.ior) {
    InteriorProperties& p = interior.properties.edit();
    p.ior = *finish.ior != 0 ? *finish.ior : 1;
    p.dispersion = 1;
  }
  if (finish.caustics) interior.properties.edit().caustics = *finish.caustics;
  const float refraction = finish.refraction.value_or(1.0f);
  if (interior.properties->refraction != refraction) interior.properties.edit().refraction = refraction;
}

PlacedTexture SceneBuilder::place(const Placed& placed) {
  if (placed.texture == nullptr) return {};
  return {built_.textures->texture(placed.texture), placed.to_world};
}

void SceneBuilder::dress(const Object& object, const Context& own, Leaf& leaf) {
  leaf.uv_mapping = own.uv_mapping;
  leaf.texture = place(own.texture);
  if (own.interior_texture.texture != nullptr) leaf.further.edit().inner = place(own.interior_texture);
  dress_parts(object, own, leaf);
  const auto opaque = [](const PlacedTexture& t) { return t.texture == nullptr || t.texture->opaque; };
  leaf.opaque = leaf.texture.texture != nullptr && opaque(leaf.texture) && opaque(leaf.further->inner) &&
                std::ranges::all_of(leaf.further->parts, opaque);
}

void SceneBuilder::dress_parts(const Object& object, const Context& own, Leaf& leaf) {
  const SharedTransform whole = object.uv_mapping ? SharedTransform() : own.to_world;
  object.shape()->visit(
      [&](const auto& shape) {
        using Description = std::decay_t<decltype(shape)>;
        if constexpr (std::is_same_v<Description, Mesh>) {
          for (const TexturePtr& texture : shape.data->textures) leaf.further.edit().parts.push_back(place({texture, whole}));
        } else if constexpr (std::is_same_v<Description, Blob>) {
          if (!shape.mixes_textures()) return;
          for (const auto& component : shape.components)
            leaf.further.edit().parts.push_back(place({component.texture, component.texture_placement.then(whole)}));
        }
      });
}

}  // namespace lute
