#include "parser/statement/normal.hpp"

#include "parser/statement/blend_map.hpp"
#include "parser/statement/pattern.hpp"
#include "parser/statement/state.hpp"

namespace lute {
namespace {

constexpr float kDefaultAccuracy = 0.02f;

// The items of checker, brick, ...; without any the pattern's own heights are the bumps.
void parse_list(Reader& reader, Normal& normal) {
  const auto length = static_cast<std::size_t>(list_length(normal.body));
  normal.accuracy = kDefaultAccuracy;
  const NormalPtr& base = statements_of(reader).defaults().normal;
  NormalMap map;
  while (map.entries.size() < length && reader.accept(Word::kNormal)) {
    const auto position = static_cast<float>(map.entries.size());
    map.entries.push_back({position, parse_normal(reader, base)});
    reader.comma();
  }
  if (map.entries.empty()) {
    normal.map = std::monostate{};
  } else {
    while (map.entries.size() < length) map.entries.push_back({static_cast<float>(map.entries.size()), base});
    normal.map = std::move(map);
  }
  close_list_pattern(reader, normal.body);
}

bool accept_normal_pattern(Reader& reader, Normal& normal) {
  if (at_color_word(reader)) {
    reader.take();
    reader.error("Keyword 'color' can only be used in a pigment or density statement.");
  }
  const bool loses_map = std::holds_alternative<UvMapping>(normal.body.pattern);
  const ParsedPattern parsed = accept_pattern(reader, normal.body, BodyKind::kNormal);
  if (!parsed.found) return false;
  if (loses_map) normal.map = std::monostate{};
  if (parsed.bump_size) normal.amount = *parsed.bump_size;
  if (std::holds_alternative<UvMapping>(normal.body.pattern)) {
    NormalMap map;
    map.entries.push_back({0, parse_normal_items(reader, statements_of(reader).defaults().normal)});
    normal.map = std::move(map);
  } else if (list_length(normal.body) > 0) {
    parse_list(reader, normal);
  }
  return true;
}

bool accept_map(Reader& reader, Normal& normal) {
  const bool average = std::holds_alternative<Average>(normal.body.pattern);
  if (reader.accept(Word::kNormalMap)) {
    require_map_allowed(reader, normal.body, Word::kNormalMap);
    normal.map = *parse_normal_map(reader, average);
  } else if (reader.accept(Word::kSlopeMap)) {
    require_map_allowed(reader, normal.body, Word::kSlopeMap);
    normal.map = *parse_slope_map(reader);
  } else {
    return false;
  }
  return true;
}

void parse_modifiers(Reader& reader, Normal& normal) {
  while (true) {
    if (reader.accept(Word::kBumpSize)) normal.amount = static_cast<float>(reader.number());
    else if (reader.accept(Word::kAccuracy)) normal.accuracy = static_cast<float>(reader.number());
    else if (reader.accept(Word::kNoBumpScale)) normal.no_bump_scale = true;
    else if (!accept_map(reader, normal) && !accept_pattern_modifier(reader, normal.body)) break;
  }
}

}  // namespace

NormalPtr parse_normal_items(Reader& reader, const NormalPtr& base) {
  NestingGuard guard(reader);
  const SourceLocation where = reader.next_location();
  Normal normal = base != nullptr ? *base : Normal{};
  if (const auto named = reader.accept_identifier<NormalPtr>()) normal = **named;
  normal.where = where;
  accept_normal_pattern(reader, normal);
  if (std::holds_alternative<NoPattern>(normal.body.pattern)) statements_of(reader).untyped_normals = true;
  reader.comma();
  if (const auto amount = reader.optional_number()) normal.amount = static_cast<float>(*amount);
  parse_modifiers(reader, normal);
  require_complete_pattern(reader, normal.body);
  if (std::holds_alternative<Average>(normal.body.pattern) && !std::holds_alternative<NormalMap>(normal.map))
    reader.error("Average must have map.");
  return shared(reader, std::move(normal));
}

NormalPtr parse_normal(Reader& reader, const NormalPtr& base) {
  reader.open(Word::kNormal);
  NormalPtr normal = parse_normal_items(reader, base);
  reader.close(Word::kNormal);
  return normal;
}

}  // namespace lute
