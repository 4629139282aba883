#include "parser/statement/texture.hpp"

#include "parser/statement/blend_map.hpp"
#include "parser/statement/finish.hpp"
#include "parser/statement/material_map.hpp"
#include "parser/statement/normal.hpp"
#include "parser/statement/old_texture.hpp"
#include "parser/statement/pattern.hpp"
#include "parser/statement/pigment.hpp"
#include "parser/statement/state.hpp"
#include "parser/statement/texture_edit.hpp"
#include "parser/statement/transformation.hpp"

namespace lute {
namespace {

using Layers = std::vector<TextureLayer>;

TextureLayer& top_layer(Texture& texture) { return std::get<Layers>(texture.content).back(); }

// The bare identifiers that a texture may begin with.
bool accept_layer_identifier(Reader& reader, TextureLayer& layer) {
  if (const auto pigment = reader.accept_identifier<PigmentPtr>()) layer.pigment = *pigment;
  else if (const auto normal = reader.accept_identifier<NormalPtr>()) layer.normal = *normal;
  else if (const auto finish = reader.accept_identifier<FinishPtr>()) layer.finish = *finish;
  else return false;
  return true;
}

bool accept_layer_block(Reader& reader, TextureLayer& layer) {
  if (reader.accept(Word::kPigment)) layer.pigment = parse_pigment(reader, layer.pigment);
  else if (reader.accept(Word::kNormal)) layer.normal = parse_normal(reader, layer.normal);
  else if (reader.accept(Word::kFinish)) layer.finish = parse_finish(reader, layer.finish);
  else return false;
  return true;
}

// What moves a whole texture, with all its layers or as a pattern.
bool accept_whole_item(Reader& reader, Texture& texture) {
  if (reader.accept(Word::kNoBumpScale)) {
    texture.no_bump_scale = true;
    return true;
  }
  const auto transform = accept_transformation(reader);
  if (!transform) return false;
  charge_layers(reader, texture);
  texture = *moved(std::make_shared<const Texture>(std::move(texture)), *transform);
  return true;
}

// tiles { texture {...} tile2 texture {...} }: a checker with the second at 0 and the first at 1.
void parse_tiles(Reader& reader, Texture& texture) {
  reader.open(Word::kTiles);
  TexturePtr first, second;
  while (reader.accept(Word::kTexture)) first = layered(reader, first, parse_texture(reader));
  if (first == nullptr) reader.error("First texture missing from tiles");
  reader.expect(Word::kTile2);
  while (reader.accept(Word::kTexture)) second = layered(reader, second, parse_texture(reader));
  if (second == nullptr) reader.error("Second texture missing from tiles");
  reader.close(Word::kTiles);
  PatternedTexture tiles;
  tiles.body.pattern = AnyPattern(Checker{});
  tiles.body.frequency = Checker::kFrequency;
  tiles.map.entries = {{0, second}, {1, first}};
  texture.content = std::move(tiles);
}

void parse_texture_list(Reader& reader, PatternedTexture& patterned) {
  const auto length = static_cast<std::size_t>(list_length(patterned.body));
  TextureMap map;
  while (map.entries.size() < length && reader.accept(Word::kTexture)) {
    const auto position = static_cast<float>(map.entries.size());
    map.entries.push_back({position, parse_texture(reader)});
    reader.comma();
  }
  while (map.entries.size() < length)
    map.entries.push_back({static_cast<float>(map.entries.size()), statements_of(reader).default_texture()});
  patterned.map = std::move(map);
  close_list_pattern(reader, patterned.body);
}

// PATTERN-BODY with texture lists, texture_map or uv_mapping; false if no pattern comes next.
bool accept_patterned(Reader& reader, Texture& texture) {
  PatternedTexture patterned;
  if (!accept_pattern(reader, patterned.body, BodyKind::kTexture).found) return false;
  if (std::holds_alternative<UvMapping>(patterned.body.pattern))
    patterned.map.entries.push_back({0, parse_texture_items(reader)});
  else if (list_length(patterned.body) > 0)
    parse_texture_list(reader, patterned);
  while (true) {
    if (reader.accept(Word::kTextureMap)) {
      require_map_allowed(reader, patterned.body, Word::kTextureMap);
      patterned.map = *parse_texture_map(reader, std::holds_alternative<Average>(patterned.body.pattern));
    } else if (reader.accept(Word::kNoBumpScale)) {
      texture.no_bump_scale = true;
    } else if (!accept_pattern_modifier(reader, patterned.body)) {
      break;
    }
  }
  require_complete_pattern(reader, patterned.body);
  const bool average = std::holds_alternative<Average>(patterned.body.pattern);
  if (patterned.map.entries.empty()) reader.error(average ? "Average must have map." : "Patterned texture must have texture_map.");
  texture.content = std::move(patterned);
  return true;
}

void parse_plain_items(Reader& reader, Texture& texture) {
  while (accept_layer_identifier(reader, top_layer(texture))) {
  }
  while (accept_layer_block(reader, top_layer(texture)) || accept_whole_item(reader, texture)) {
  }
}

// A texture without identifier in front.
void parse_new_texture(Reader& reader, Texture& texture) {
  if (reader.accept(Word::kTiles)) {
    parse_tiles(reader, texture);
  } else if (reader.accept(Word::kMaterialMap)) {
    parse_material_map(reader, texture);
  } else if (!accept_patterned(reader, texture)) {
    parse_plain_items(reader, texture);
    return;
  }
  while (accept_whole_item(reader, texture)) {
  }
}

TexturePtr parse_block(Reader& reader, Word keyword) {
  reader.open(keyword);
  TexturePtr texture = parse_texture_items(reader);
  reader.close(keyword);
  return texture;
}

}  // namespace

TexturePtr parse_texture_items(Reader& reader) {
  NestingGuard guard(reader);
  const SourceLocation where = reader.next_location();
  if (reader.version() < 300) return parse_old_texture_items(reader);
  Texture texture;
  if (const auto named = reader.accept_identifier<TexturePtr>()) {
    if (reader.at(TokenKind::kRightBrace) || reader.at(TokenKind::kRightSquare)) return *named;
    charge_layers(reader, **named);
    texture = **named;
    texture.where = where;
    if (is_plain(texture)) {
      parse_plain_items(reader, texture);
    } else {
      while (accept_whole_item(reader, texture)) {
      }
    }
  } else {
    texture = *statements_of(reader).default_texture();
    texture.where = where;
    parse_new_texture(reader, texture);
  }
  return shared(reader, std::move(texture));
}

TexturePtr parse_texture(Reader& reader) { return parse_block(reader, Word::kTexture); }
TexturePtr parse_interior_texture(Reader& reader) { return parse_block(reader, Word::kInteriorTexture); }

TexturePtr parse_texture_layers(Reader& reader) {
  // What follows may be a directive that uses the name being declared: it has to wait until the name holds this texture.
  reader.take();
  TexturePtr texture = parse_texture(reader);
  while (reader.accept_written(Word::kTexture)) texture = layered(reader, texture, parse_texture(reader));
  return texture;
}

bool accept_layer_item(Reader& reader, TextureOnObject& on_object) {
  if (!reader.at(Word::kPigment) && !reader.at(Word::kNormal) && !reader.at(Word::kFinish)) return false;
  // Transformations met before the first texture item do not carry the default texture that it starts from.
  if (on_object.texture == nullptr) on_object = {statements_of(reader).default_texture(), {}};
  if (!is_plain(*on_object.texture)) reader.error("Cannot layer over a patterned texture.");
  charge_layers(reader, *on_object.texture);
  fold_placement(on_object);
  Texture texture = *on_object.texture;
  accept_layer_block(reader, top_layer(texture));
  on_object.texture = shared(reader, std::move(texture));
  return true;
}

}  // namespace lute
