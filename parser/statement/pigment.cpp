#include "parser/statement/pigment.hpp"

#include "parser/statement/blend_map.hpp"
#include "parser/statement/state.hpp"
#include "parser/statement/warp.hpp"

namespace lute {
namespace {

bool is_plain_color(const Pigment& pigment) {
  return std::holds_alternative<NoPattern>(pigment.body.pattern) && std::holds_alternative<Color>(pigment.map);
}

PigmentPtr nested_base(Reader& reader, BodyKind kind) {
  return kind == BodyKind::kDensity ? std::make_shared<const Pigment>() : statements_of(reader).defaults().pigment;
}

Word block_word(BodyKind kind) { return kind == BodyKind::kDensity ? Word::kDensity : Word::kPigment; }

// The items of checker, brick, ...: pigments or colours; what is missing at the end is filled up.
void parse_pigment_list(Reader& reader, Pigment& pigment, BodyKind kind, std::size_t length) {
  PigmentMap pigments;
  while (pigments.entries.size() < length && reader.accept(block_word(kind))) {
    const auto position = static_cast<float>(pigments.entries.size());
    pigments.entries.push_back({position, kind == BodyKind::kDensity ? parse_density(reader)
                                                                     : parse_pigment(reader, nested_base(reader, kind))});
    reader.comma();
  }
  while (pigments.entries.size() < length)
    pigments.entries.push_back({static_cast<float>(pigments.entries.size()), nested_base(reader, kind)});
  pigment.map = std::move(pigments);
}

void parse_color_list(Reader& reader, Pigment& pigment, std::size_t length) {
  ColorMap colors = default_color_map(pigment.body);
  std::size_t count = 0;
  while (count < length && reader.at_color()) {
    const Color color = reader.color();
    if (count < colors.entries.size()) colors.entries[count].value = color;
    ++count;
    reader.comma();
  }
  if (count > 0) pigment.map = std::move(colors);
  else pigment.map = std::monostate{};
}

void parse_list(Reader& reader, Pigment& pigment, BodyKind kind) {
  const auto length = static_cast<std::size_t>(list_length(pigment.body));
  if (reader.at(block_word(kind))) parse_pigment_list(reader, pigment, kind, length);
  else parse_color_list(reader, pigment, length);
  close_list_pattern(reader, pigment.body);
}

// The colours of a list count as a map under another pattern, also those that were not written.
void write_out_list(Pigment& pigment) {
  if (list_length(pigment.body) > 0 && std::holds_alternative<std::monostate>(pigment.map)) pigment.map = default_color_map(pigment.body);
}

// A plain colour takes the place of a map, and gives it back to the pattern that follows.
void cover_map(Pigment& pigment) {
  if (is_plain_color(pigment)) return;
  pigment.covered_map = std::monostate{};
  if (std::holds_alternative<UvMapping>(pigment.body.pattern)) return;
  if (auto* colors = std::get_if<ColorMap>(&pigment.map)) pigment.covered_map = std::move(*colors);
  else if (auto* pigments = std::get_if<PigmentMap>(&pigment.map)) pigment.covered_map = std::move(*pigments);
}
void uncover_map(Pigment& pigment) {
  pigment.map = std::monostate{};
  if (auto* colors = std::get_if<ColorMap>(&pigment.covered_map)) pigment.map = std::move(*colors);
  else if (auto* pigments = std::get_if<PigmentMap>(&pigment.covered_map)) pigment.map = std::move(*pigments);
  pigment.covered_map = std::monostate{};
}

// The pattern's word with all that belongs to it; false if none comes next.
bool accept_pigment_pattern(Reader& reader, Pigment& pigment, BodyKind kind) {
  if (at_color_word(reader)) {
    if (kind == BodyKind::kFunction) reader.close(Word::kPattern);  // an error: a pattern has no colours
    write_out_list(pigment);
    cover_map(pigment);
    pigment.body.pattern = NoPattern{};
    pigment.map = reader.color();
    return true;
  }
  const bool was_plain = is_plain_color(pigment), was_uv_mapping = std::holds_alternative<UvMapping>(pigment.body.pattern);
  write_out_list(pigment);
  if (!accept_pattern(reader, pigment.body, kind).found) return false;
  if (was_plain) uncover_map(pigment);
  else if (was_uv_mapping) pigment.map = std::monostate{};  // its only content says nothing about the new pattern
  if (std::holds_alternative<UvMapping>(pigment.body.pattern)) {
    PigmentMap map;
    map.entries.push_back({0, parse_pigment_items(reader, nested_base(reader, kind), kind)});
    pigment.map = std::move(map);
  } else if (kind == BodyKind::kFunction) {
    close_list_pattern(reader, pigment.body);  // the value counts, no list of colours can follow
  } else if (list_length(pigment.body) > 0) {
    parse_list(reader, pigment, kind);
  }
  return true;
}

void require_pigment_map_allowed(Reader& reader, const Pigment& pigment, Word map) {
  if (is_plain_color(pigment)) refuse_map(reader, map);
  require_map_allowed(reader, pigment.body, map);
}

bool accept_map(Reader& reader, Pigment& pigment, BodyKind kind) {
  if (kind == BodyKind::kFunction) return false;
  const bool average = std::holds_alternative<Average>(pigment.body.pattern);
  if (reader.accept(Word::kColorMap)) {
    require_pigment_map_allowed(reader, pigment, Word::kColorMap);
    pigment.map = *parse_color_map(reader);
  } else if (kind == BodyKind::kPigment && reader.accept(Word::kPigmentMap)) {
    require_pigment_map_allowed(reader, pigment, Word::kPigmentMap);
    pigment.map = *parse_pigment_map(reader, average);
  } else if (kind == BodyKind::kDensity && reader.accept(Word::kDensityMap)) {
    require_pigment_map_allowed(reader, pigment, Word::kDensityMap);
    pigment.map = *parse_density_map(reader, average);
  } else {
    return false;
  }
  return true;
}

void parse_quick_color(Reader& reader, Pigment& pigment) {
  const Color color = reader.color();
  const Rgb& c = color.rgb;
  pigment.quick_color.reset();
  if (c.r != -1 && c.g != -1 && c.b != -1) pigment.quick_color = color;
}

void parse_modifiers(Reader& reader, Pigment& pigment, BodyKind kind) {
  while (true) {
    if (kind == BodyKind::kPigment && reader.accept(Word::kQuickColor)) parse_quick_color(reader, pigment);
    else if (reader.accept(Word::kNoBumpScale)) continue;
    else if (!accept_map(reader, pigment, kind) && !accept_pattern_modifier(reader, pigment.body)) break;
  }
}

void require_complete(Reader& reader, const Pigment& pigment) {
  require_complete_pattern(reader, pigment.body);
  if (std::holds_alternative<Average>(pigment.body.pattern) && !std::holds_alternative<PigmentMap>(pigment.map))
    reader.error("Average must have map.");
}

PigmentPtr parse_block(Reader& reader, const PigmentPtr& base, BodyKind kind, Word keyword) {
  reader.open(keyword);
  PigmentPtr pigment = parse_pigment_items(reader, base, kind);
  reader.close(keyword);
  return pigment;
}

}  // namespace

PigmentPtr parse_pigment_items(Reader& reader, const PigmentPtr& base, BodyKind kind) {
  NestingGuard guard(reader);
  const SourceLocation where = reader.next_location();
  Pigment pigment = *base;
  bool named = false;
  if (kind == BodyKind::kPigment) {
    if (const auto identifier = reader.accept_identifier<PigmentPtr>()) {
      pigment = **identifier;
      named = true;
    }
  } else if (kind == BodyKind::kDensity) {
    if (const auto identifier = reader.accept_identifier<Density>()) {
      pigment = *identifier->pigment;
      named = true;
    }
  }
  pigment.where = where;
  const bool typed = accept_pigment_pattern(reader, pigment, kind);
  if (!typed && !named && kind == BodyKind::kPigment) reader.warning("Pigment type unspecified or not 1st item.");
  parse_modifiers(reader, pigment, kind);
  require_complete(reader, pigment);
  return shared(reader, std::move(pigment));
}

PigmentPtr parse_pigment(Reader& reader, const PigmentPtr& base) {
  return parse_block(reader, base, BodyKind::kPigment, Word::kPigment);
}

PigmentPtr parse_density(Reader& reader) {
  return parse_block(reader, std::make_shared<const Pigment>(), BodyKind::kDensity, Word::kDensity);
}

PigmentPtr parse_function_pattern(Reader& reader) {
  return parse_block(reader, std::make_shared<const Pigment>(), BodyKind::kFunction, Word::kPattern);
}

bool accept_old_pigment_item(Reader& reader, Pigment& pigment) {
  switch (reader.word()) {
    case Word::kTurbulence: case Word::kOctaves: case Word::kOmega: case Word::kLambda:
      return accept_turbulence_item(reader, classic_turbulence(pigment.body.warps));
    case Word::kQuickColor:
      reader.take();
      parse_quick_color(reader, pigment);
      return true;
    case Word::kAgate: case Word::kBozo: case Word::kGranite: case Word::kLeopard: case Word::kMarble: case Word::kMandel:
    case Word::kOnion: case Word::kSpotted: case Word::kWood: case Word::kGradient: case Word::kChecker: case Word::kHexagon:
    case Word::kSquare: case Word::kTriangular: case Word::kImageMap: {
      const Wave wave = pigment.body.wave;
      accept_pigment_pattern(reader, pigment, BodyKind::kPigment);
      pigment.body.wave = wave;  // marble and wood had no wave of their own
      return true;
    }
    case Word::kColorMap: return accept_map(reader, pigment, BodyKind::kPigment);
    default: return at_color_word(reader) && accept_pigment_pattern(reader, pigment, BodyKind::kPigment);
  }
}

}  // namespace lute
