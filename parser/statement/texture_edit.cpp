#include "parser/statement/texture_edit.hpp"

#include "engine/scene/media.hpp"
#include "parser/session.hpp"
#include "parser/statement/state.hpp"

namespace lute {
namespace {

using Layers = std::vector<TextureLayer>;

// Up to version 3.1 an upper layer lets its filtered light pass unfiltered.
void filter_to_transmit(Color& color) {
  color.transmit += color.filter;
  color.filter = 0;
}

PigmentPtr unfiltered(const PigmentPtr& pigment) {
  Pigment changed = *pigment;
  if (auto* color = std::get_if<Color>(&changed.map)) filter_to_transmit(*color);
  if (auto* colors = std::get_if<ColorMap>(&changed.map))
    for (auto& entry : colors->entries) filter_to_transmit(entry.value);
  if (auto* pigments = std::get_if<PigmentMap>(&changed.map))
    for (auto& entry : pigments->entries) entry.value = unfiltered(entry.value);
  return std::make_shared<const Pigment>(std::move(changed));
}

// The layers of a plain texture with its no_bump_scale put into their normals.
Layers layers_of(const Texture& texture) {
  Layers layers = std::get<Layers>(texture.content);
  if (!texture.no_bump_scale) return layers;
  for (TextureLayer& layer : layers) {
    if (layer.normal == nullptr) continue;
    Normal normal = *layer.normal;
    normal.no_bump_scale = true;
    layer.normal = std::make_shared<const Normal>(std::move(normal));
  }
  return layers;
}

}  // namespace

bool is_plain(const Texture& texture) { return std::holds_alternative<Layers>(texture.content); }

PigmentPtr moved(const PigmentPtr& pigment, const Transform& transform) {
  const bool plain_color = std::holds_alternative<Color>(pigment->map) && pigment->body.warps.empty();
  if (plain_color || transform.identity()) return pigment;
  Pigment changed = *pigment;
  prepend_transform(changed.body.warps, transform);
  return std::make_shared<const Pigment>(std::move(changed));
}

NormalPtr moved(const NormalPtr& normal, const Transform& transform) {
  if (normal == nullptr || transform.identity()) return normal;
  Normal changed = *normal;
  prepend_transform(changed.body.warps, transform);
  return std::make_shared<const Normal>(std::move(changed));
}

TexturePtr moved(const TexturePtr& texture, const Transform& transform) {
  if (texture == nullptr || transform.identity()) return texture;
  Texture changed = *texture;
  if (auto* layers = std::get_if<Layers>(&changed.content)) {
    for (TextureLayer& layer : *layers) {
      layer.pigment = moved(layer.pigment, transform);
      layer.normal = moved(layer.normal, transform);
    }
  } else {
    prepend_transform(std::get<PatternedTexture>(changed.content).body.warps, transform);
  }
  return std::make_shared<const Texture>(std::move(changed));
}

MediaPtr moved(const MediaPtr& media, const Transform& transform) {
  if (media->densities.empty() || transform.identity()) return media;
  Media changed = *media;
  for (PigmentPtr& density : changed.densities) density = moved(density, transform);
  return std::make_shared<const Media>(std::move(changed));
}

void charge_layers(Reader& reader, const Texture& texture) {
  constexpr std::uint64_t kLayer = sizeof(TextureLayer) + sizeof(Pigment) + sizeof(Normal);  // if it is changed
  if (is_plain(texture)) reader.session().resources.charge(std::get<Layers>(texture.content).size() * kLayer);
}

void fold_placement(TextureOnObject& texture) {
  texture.texture = moved(texture.texture, texture.placement);
  texture.placement = {};
}

TexturePtr layered(Reader& reader, const TexturePtr& below, const TexturePtr& top) {
  // Up to version 3.1 layers do not filter what lies below them, whenever they are put on an object or together.
  const bool filters = reader.version() > 310;
  const bool single = !is_plain(*top) || std::get<Layers>(top->content).size() < 2;
  if (below == nullptr && (filters || single)) return top;
  if (below != nullptr && !is_plain(*below)) reader.error("Cannot layer over a patterned texture.");
  if (!is_plain(*top)) reader.error("Cannot layer a patterned texture over another.");
  Layers layers;
  if (below != nullptr) {
    charge_layers(reader, *below);
    layers = layers_of(*below);
  }
  charge_layers(reader, *top);
  for (TextureLayer layer : layers_of(*top)) {
    if (!filters && !layers.empty()) layer.pigment = unfiltered(layer.pigment);
    layers.push_back(std::move(layer));
  }
  Texture result;
  result.where = top->where;
  result.content = std::move(layers);
  return shared(reader, std::move(result));
}

void add_texture(Reader& reader, TextureOnObject& on_object, const TexturePtr& texture) {
  if (on_object.texture != nullptr) charge_layers(reader, *on_object.texture);
  fold_placement(on_object);
  on_object.texture = layered(reader, on_object.texture, texture);
}

}  // namespace lute
