#include "parser/statement/interior.hpp"

#include "parser/statement/state.hpp"
#include "parser/statement/texture.hpp"
#include "parser/statement/texture_edit.hpp"
#include "parser/statement/transformation.hpp"

namespace lute {
namespace {

constexpr float kCausticsScale = 45;  // the exponent that `caustics 1` stands for

float real(Reader& reader) { return static_cast<float>(reader.number()); }

bool accept_interior_item(Reader& reader, Interior& interior) {
  if (reader.accept(Word::kIor)) {
    interior.ior = real(reader);
  } else if (reader.accept(Word::kDispersion)) {
    interior.dispersion = real(reader);
  } else if (reader.accept(Word::kDispersionSamples)) {
    interior.dispersion_samples = reader.integer();
    if (interior.dispersion_samples < 2) reader.error("Dispersion samples minimum is 2.");
  } else if (reader.accept(Word::kCaustics)) {
    interior.caustics = real(reader) * kCausticsScale;
  } else if (reader.accept(Word::kFadeDistance)) {
    interior.fade_distance = real(reader);
  } else if (reader.accept(Word::kFadePower)) {
    interior.fade_power = real(reader);
  } else if (reader.accept(Word::kFadeColor)) {
    interior.fade_color = reader.rgb();
  } else if (reader.accept(Word::kMedia)) {
    interior.media.push_back(parse_media(reader));
  } else if (reader.accept(Word::kRefraction)) {
    interior.refraction = real(reader);
  } else {
    return false;
  }
  return true;
}

void replace_by(Material& material, const Material& named, Reader& reader) {
  const auto add_all = [&](TextureOnObject& to, const TextureOnObject& from) {
    if (from.texture != nullptr) add_texture(reader, to, moved(from.texture, from.placement));
  };
  add_all(material.texture, named.texture);
  add_all(material.interior_texture, named.interior_texture);
  material.interior = named.interior;
}

}  // namespace

InteriorPtr parse_interior(Reader& reader, const InteriorPtr& base) {
  NestingGuard guard(reader);
  const SourceLocation where = reader.location();
  reader.open(Word::kInterior);
  Interior interior;
  if (base != nullptr) interior = *base;
  if (const auto named = reader.accept_identifier<InteriorPtr>()) interior = **named;
  interior.where = where;
  while (accept_interior_item(reader, interior)) {
  }
  reader.close(Word::kInterior);
  return std::make_shared<const Interior>(std::move(interior));
}

InteriorPtr moved(const InteriorPtr& interior, const Transform& transform) {
  if (interior == nullptr || interior->media.empty() || transform.identity()) return interior;
  Interior changed = *interior;
  for (MediaPtr& media : changed.media) media = moved(media, transform);
  return std::make_shared<const Interior>(std::move(changed));
}

void parse_material(Reader& reader, Material& material, bool uv_mapping) {
  NestingGuard guard(reader);
  reader.open(Word::kMaterial);
  if (const auto named = reader.accept_identifier<MaterialPtr>()) replace_by(material, **named, reader);
  while (true) {
    if (reader.accept(Word::kTexture)) {
      add_texture(reader, material.texture, parse_texture(reader));
    } else if (reader.accept(Word::kInteriorTexture)) {
      add_texture(reader, material.interior_texture, parse_interior_texture(reader));
    } else if (reader.accept(Word::kInterior)) {
      material.interior = parse_interior(reader, material.interior);
    } else if (const auto transform = accept_transformation(reader)) {
      if (!uv_mapping) material.texture.placement = material.texture.placement.then(*transform);
      material.interior = moved(material.interior, *transform);
    } else {
      break;
    }
  }
  reader.close(Word::kMaterial);
}

}  // namespace lute
