#include "parser/statement/old_texture.hpp"

#include "parser/statement/finish.hpp"
#include "parser/statement/material_map.hpp"
#include "parser/statement/normal.hpp"
#include "parser/statement/pattern.hpp"
#include "parser/statement/pigment.hpp"
#include "parser/statement/state.hpp"
#include "parser/statement/texture_edit.hpp"
#include "parser/statement/transformation.hpp"

namespace lute {
namespace {

using Layers = std::vector<TextureLayer>;

TextureLayer& top_layer(Texture& texture) { return std::get<Layers>(texture.content).back(); }

bool accept_part(Reader& reader, TextureLayer& layer) {
  if (reader.accept(Word::kPigment)) layer.pigment = parse_pigment(reader, layer.pigment);
  else if (reader.accept(Word::kNormal)) layer.normal = parse_normal(reader, layer.normal);
  else if (reader.accept(Word::kFinish)) layer.finish = parse_finish(reader, layer.finish);
  else if (const auto pigment = reader.accept_identifier<PigmentPtr>()) layer.pigment = *pigment;
  else if (const auto normal = reader.accept_identifier<NormalPtr>()) layer.normal = *normal;
  else if (const auto finish = reader.accept_identifier<FinishPtr>()) layer.finish = *finish;
  else return false;
  return true;
}

bool accept_pigment_item(Reader& reader, TextureLayer& layer) {
  Pigment pigment = *layer.pigment;
  if (!accept_old_pigment_item(reader, pigment)) return false;
  layer.pigment = std::make_shared<const Pigment>(std::move(pigment));
  return true;
}

bool accept_normal_item(Reader& reader, TextureLayer& layer) {
  Normal normal = layer.normal != nullptr ? *layer.normal : Normal{};
  switch (reader.word()) {
    case Word::kBumps: case Word::kDents: case Word::kRipples: case Word::kWaves: case Word::kWrinkles:
      accept_pattern(reader, normal.body, BodyKind::kNormal);
      normal.amount = static_cast<float>(reader.number());
      break;
    case Word::kBumpMap:
      if (const auto size = accept_pattern(reader, normal.body, BodyKind::kNormal).bump_size) normal.amount = *size;
      break;
    case Word::kFrequency: reader.take(); normal.body.frequency = static_cast<float>(reader.number()); break;
    case Word::kPhase: reader.take(); normal.body.phase = static_cast<float>(reader.number()); break;
    default: return false;
  }
  layer.normal = std::make_shared<const Normal>(std::move(normal));
  return true;
}

bool accept_finish_item(Reader& reader, TextureLayer& layer) {
  Finish finish = *layer.finish;
  const auto real = [&] { return static_cast<float>(reader.number()); };
  if (reader.accept(Word::kAmbient)) finish.ambient = Rgb(real());
  else if (reader.accept(Word::kBrilliance)) finish.brilliance = real();
  else if (reader.accept(Word::kDiffuse)) finish.raw_diffuse = finish.diffuse = real();
  else if (reader.accept(Word::kReflection)) finish.reflection_min = finish.reflection_max = Rgb(real());
  else if (reader.accept(Word::kPhong)) finish.phong = real();
  else if (reader.accept(Word::kPhongSize)) finish.phong_size = real();
  else if (reader.accept(Word::kSpecular)) finish.specular = real();
  else if (reader.accept(Word::kRoughness)) {
    const float roughness = real();
    finish.specular_exponent = roughness != 0 ? 1 / roughness : 0;
  } else if (reader.accept(Word::kMetallic)) {
    finish.metallic = static_cast<float>(reader.optional_number().value_or(1));
  } else if (reader.accept(Word::kCrand) || reader.at_number()) {
    finish.crand = real();
  } else if (reader.accept(Word::kIor)) {
    finish.ior = real();
  } else if (reader.accept(Word::kRefraction)) {
    finish.refraction = real();
  } else {
    return false;
  }
  layer.finish = std::make_shared<const Finish>(finish);
  return true;
}

bool accept_plain_item(Reader& reader, Texture& texture) {
  if (!is_plain(texture)) return false;
  TextureLayer& layer = top_layer(texture);
  return accept_part(reader, layer) || accept_pigment_item(reader, layer) || accept_normal_item(reader, layer) ||
         accept_finish_item(reader, layer);
}

bool accept_transformation_of_all(Reader& reader, Texture& texture) {
  const auto transform = accept_transformation(reader);
  if (!transform) return false;
  texture = *moved(std::make_shared<const Texture>(std::move(texture)), *transform);
  return true;
}

}  // namespace

TexturePtr parse_old_texture_items(Reader& reader) {
  Texture texture = *statements_of(reader).default_texture();
  texture.where = reader.next_location();
  if (reader.accept(Word::kMaterialMap)) parse_material_map(reader, texture);
  while (true) {
    if (const auto named = reader.accept_identifier<TexturePtr>()) texture = **named;
    else if (!accept_plain_item(reader, texture) && !accept_transformation_of_all(reader, texture)) break;
  }
  return shared(reader, std::move(texture));
}

}  // namespace lute
