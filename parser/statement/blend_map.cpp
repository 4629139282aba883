#include "parser/statement/blend_map.hpp"

#include "parser/statement/normal.hpp"
#include "parser/statement/pigment.hpp"
#include "parser/statement/state.hpp"
#include "parser/statement/texture.hpp"

namespace lute {
namespace {

constexpr std::size_t kMaxEntries = 256;

template <class T>
void add_entry(Reader& reader, BlendMap<T>& map, float position, T value) {
  if (map.entries.size() == kMaxEntries) reader.error("Blend_Map too long.");
  map.entries.push_back({position, std::move(value)});
}

// `{ IDENTIFIER }` or `{ [ ... ] [ ... ] }`; `entry` reads one, between its brackets.
template <class Map, class Entry>
std::shared_ptr<const Map> parse_map(Reader& reader, Word keyword, bool identifiers, const Entry& entry) {
  NestingGuard guard(reader);
  reader.open(keyword);
  std::shared_ptr<const Map> result;
  if (auto named = identifiers ? reader.accept_identifier<std::shared_ptr<const Map>>() : std::nullopt) {
    result = *named;
  } else {
    if (identifiers && reader.at(TokenKind::kIdentifier)) reader.error("Wrong identifier type");
    Map map;
    while (reader.accept(TokenKind::kLeftSquare)) {
      entry(map);
      reader.expect(TokenKind::kRightSquare);
    }
    if (map.entries.empty() && keyword == Word::kColorMap) reader.error("Must have at least one color in color map.");
    if (map.entries.empty()) reader.error("Must have at least one entry in map.");
    result = std::make_shared<const Map>(std::move(map));
  }
  reader.close(keyword);
  return result;
}

float position(Reader& reader) {
  const auto value = static_cast<float>(reader.number());
  reader.comma();
  return value;
}

float position_or_weight(Reader& reader, bool average) {
  if (average && !reader.at_number() && !at_color_word(reader)) return 1;  // a colour is taken for the weight
  return position(reader);
}

// Exact repetitions are one entry.
void add_color(Reader& reader, ColorMap& map, float at, const Color& color) {
  if (!map.entries.empty() && map.entries.back().position == at && map.entries.back().value == color) return;
  add_entry(reader, map, at, color);
}

// [ F , COLOUR ] or, of old, [ F , F COLOUR color COLOUR ].
void parse_color_entry(Reader& reader, ColorMap& map) {
  const float at = position(reader);
  if (at_color_word(reader)) {
    add_color(reader, map, at, reader.color());
    return;
  }
  if (!reader.at_number() || reader.at(TokenKind::kLess)) reader.error_expected("color");
  const Number value = reader.additive_expression(1);
  if (value.count == 5) {
    add_color(reader, map, at, value.color());
    return;
  }
  if (!value.is_float()) reader.error_expected("color");
  if (!at_color_word(reader)) reader.error_expected("color");
  add_color(reader, map, at, reader.color());
  if (!reader.at(Word::kColor)) reader.error_expected("color");
  add_color(reader, map, static_cast<float>(value.c[0]), reader.color());
}

std::string_view pattern_keyword(const PatternBody& body) {
  const auto* pattern = std::get_if<AnyPattern>(&body.pattern);
  return pattern == nullptr ? std::string_view() : std::visit([](const auto& p) { return p.kKeyword; }, *pattern);
}

}  // namespace

ColorMapPtr parse_color_map(Reader& reader) {
  return parse_map<ColorMap>(reader, Word::kColorMap, true, [&](ColorMap& map) { parse_color_entry(reader, map); });
}

SlopeMapPtr parse_slope_map(Reader& reader) {
  return parse_map<SlopeMap>(reader, Word::kSlopeMap, true, [&](SlopeMap& map) {
    const float at = position(reader);
    const dvec2 value = reader.vector2();
    add_entry(reader, map, at, HeightAndSlope{value.x, value.y});
  });
}

PigmentMapPtr parse_pigment_map(Reader& reader, bool average) {
  return parse_map<PigmentMap>(reader, Word::kPigmentMap, true, [&](PigmentMap& map) {
    const float at = position_or_weight(reader, average);
    add_entry(reader, map, at, parse_pigment_items(reader, statements_of(reader).defaults().pigment, BodyKind::kPigment));
  });
}

// An identifier cannot be used here, whatever the manual says (specification chapter 11 §15).
PigmentMapPtr parse_density_map(Reader& reader, bool average) {
  return parse_map<PigmentMap>(reader, Word::kDensityMap, false, [&](PigmentMap& map) {
    const float at = position_or_weight(reader, average);
    add_entry(reader, map, at, parse_pigment_items(reader, std::make_shared<const Pigment>(), BodyKind::kDensity));
  });
}

NormalMapPtr parse_normal_map(Reader& reader, bool average) {
  return parse_map<NormalMap>(reader, Word::kNormalMap, true, [&](NormalMap& map) {
    const float at = position_or_weight(reader, average);
    add_entry(reader, map, at, parse_normal_items(reader, statements_of(reader).defaults().normal));
  });
}

TextureMapPtr parse_texture_map(Reader& reader, bool average) {
  return parse_map<TextureMap>(reader, Word::kTextureMap, true, [&](TextureMap& map) {
    const float at = position_or_weight(reader, average);
    add_entry(reader, map, at, parse_texture_items(reader));
  });
}

void refuse_map(Reader& reader, Word map) {
  if (map == Word::kColorMap) reader.error("Cannot use color_map with this pattern type.");
  const char* type = map == Word::kPigmentMap    ? "pigment"
                     : map == Word::kDensityMap ? "density"
                     : map == Word::kTextureMap ? "pattern"
                                                : "normal";
  reader.error("Keyword '" + std::string(spelling(map)) + "' cannot be used with this " + type + " type.");
}

void require_map_allowed(Reader& reader, const PatternBody& body, Word map) {
  const std::string_view keyword = pattern_keyword(body);
  const bool colors = map == Word::kColorMap || map == Word::kSlopeMap;
  const bool refused = list_length(body) > 0 || keyword == "image_map" || keyword == "bump_map" ||
                       (colors && std::holds_alternative<Average>(body.pattern)) || (keyword == "facets" && map == Word::kNormalMap);
  if (refused) refuse_map(reader, map);
}

}  // namespace lute
