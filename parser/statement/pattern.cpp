#include "parser/statement/pattern.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "parser/statement/pattern_arguments.hpp"
#include "parser/statement/transformation.hpp"
#include "parser/statement/warp.hpp"

namespace lute {
namespace {

constexpr bool is_one_of(std::string_view keyword, std::initializer_list<std::string_view> keywords) {
  return std::find(keywords.begin(), keywords.end(), keyword) != keywords.end();
}

// Which bodies know a pattern (specification chapters 11 §10.2 and 50 §9). `material_map` is a form of texture {}.
constexpr bool is_allowed(std::string_view keyword, BodyKind kind) {
  if (keyword == "material_map") return false;
  if (keyword == "image_map") return kind == BodyKind::kPigment || kind == BodyKind::kDensity;
  if (is_one_of(keyword, {"bump_map", "facets"})) return kind == BodyKind::kNormal;
  if (kind == BodyKind::kFunction)
    return !is_one_of(keyword, {"square", "triangular", "slope", "aoi", "pavement", "tiling"});
  return true;
}

template <class Pattern>
void set_pattern(PatternBody& body, Pattern pattern) {
  // Zero stays in force if a later body reuses this one with another pattern.
  if constexpr (Pattern::kFrequency == 0) body.frequency = 0;
  if constexpr (Pattern::kWave != Wave::kRamp) body.wave = Pattern::kWave;
  if constexpr (Pattern::kKeyword == std::string_view("agate")) classic_turbulence(body.warps);
  body.pattern = AnyPattern(std::move(pattern));
}

template <class Pattern>
bool accept_if_named(Reader& reader, PatternBody& body, BodyKind kind, std::string_view keyword, ParsedPattern& parsed) {
  if (Pattern::kKeyword != keyword || !is_allowed(keyword, kind)) return false;
  reader.take();
  Pattern pattern;
  parse_arguments(reader, pattern, parsed);
  set_pattern(body, std::move(pattern));
  return true;
}

template <std::size_t... Index>
bool accept_from_table(Reader& reader, PatternBody& body, BodyKind kind, std::string_view keyword, ParsedPattern& parsed,
                       std::index_sequence<Index...>) {
  return (accept_if_named<std::variant_alternative_t<Index, AnyPattern>>(reader, body, kind, keyword, parsed) || ...);
}

bool accept_wave(Reader& reader, PatternBody& body) {
  if (reader.accept(Word::kRampWave)) body.wave = Wave::kRamp;
  else if (reader.accept(Word::kTriangleWave)) body.wave = Wave::kTriangle;
  else if (reader.accept(Word::kSineWave)) body.wave = Wave::kSine;
  else if (reader.accept(Word::kScallopWave)) body.wave = Wave::kScallop;
  else if (reader.accept(Word::kCubicWave)) body.wave = Wave::kCubic;
  else if (reader.accept(Word::kPolyWave)) {
    body.wave = Wave::kPoly;
    if (const auto exponent = reader.optional_number()) body.wave_exponent = static_cast<float>(*exponent);
  } else {
    return false;
  }
  return true;
}

bool at_turbulence_word(Word word) {
  return word == Word::kTurbulence || word == Word::kOctaves || word == Word::kOmega || word == Word::kLambda;
}

int noise_generator(Reader& reader) {
  const int generator = reader.integer();
  if (generator < 0 || generator > 3) reader.error("Value for noise_generator must be 0, 1, 2, or 3.");
  return generator;
}

// A word of one pattern, or of one kind of body, and what is said where it does not belong.
struct OwnedWord {
  Word word;
  std::string_view fault;
};
constexpr std::array kOwnedWords = {
    OwnedWord{Word::kAgateTurb, "cannot be used with non-agate."},
    OwnedWord{Word::kBrickSize, "cannot be used with non-brick."},
    OwnedWord{Word::kMortar, "cannot be used with non-brick."},
    OwnedWord{Word::kControl0, "cannot be used with this pattern."},
    OwnedWord{Word::kControl1, "cannot be used with this pattern."},
    OwnedWord{Word::kSize, "can only be used in a facets statement."},
    OwnedWord{Word::kCoords, "can only be used in a facets statement."},
    OwnedWord{Word::kMetric, "can only be used in a facets or crackle statement."},
    OwnedWord{Word::kForm, "can only be used in a crackle or pavement statement."},
    OwnedWord{Word::kOffset, "can only be used in a crackle statement."},
    OwnedWord{Word::kSolid, "can only be used in a crackle statement."},
    OwnedWord{Word::kInterpolate, "can only be used in a density_file statement."},
    OwnedWord{Word::kExterior, "can only be used in a julia, mandel, magnet or pavement statement."},
    OwnedWord{Word::kInterior, "can only be used in a julia, mandel, magnet or pavement statement."},
    OwnedWord{Word::kExponent, "can only be used in a julia or mandel statement."},
    OwnedWord{Word::kNumberOfSides, "can only be used in a pavement statement."},
    OwnedWord{Word::kNumberOfTiles, "can only be used in a pavement statement."},
    OwnedWord{Word::kPattern, "can only be used in a pavement statement."},
    OwnedWord{Word::kColorMap, "can only be used in a pigment statement."},
    OwnedWord{Word::kPigmentMap, "can only be used in a pigment statement."},
    OwnedWord{Word::kQuickColor, "can only be used in a pigment statement."},
    OwnedWord{Word::kNormalMap, "can only be used in a normal statement."},
    OwnedWord{Word::kSlopeMap, "can only be used in a normal statement."},
    OwnedWord{Word::kBumpSize, "can only be used in a normal statement."},
    OwnedWord{Word::kTextureMap, "can only be used in a texture statement."},
    OwnedWord{Word::kDensityMap, "can only be used in a density statement."},
};

[[noreturn]] void refuse(Reader& reader, std::string_view fault) {
  const std::string word(spelling(reader.take().word()));
  reader.error("Keyword '" + word + "' " + std::string(fault));
}

// Patterns that only one kind of body knows.
void reject_foreign_pattern(Reader& reader, BodyKind kind) {
  const Word word = reader.word();
  const bool of_normals = word == Word::kFacets || word == Word::kBumpMap;
  if (of_normals && kind != BodyKind::kNormal) refuse(reader, "can only be used in a normal statement.");
  if (word == Word::kImageMap && !is_allowed("image_map", kind)) refuse(reader, "can only be used in a pigment statement.");
}

// A word that belongs to another pattern or body is a mistake of its own kind.
void reject_foreign_word(Reader& reader) {
  const Word word = reader.word();
  if (word == Word::kAccuracy) {
    reader.take();
    reader.error("accuracy can only be used with normal patterns.");
  }
  for (const OwnedWord& owned : kOwnedWords)
    if (owned.word == word) refuse(reader, owned.fault);
}

}  // namespace

ParsedPattern accept_pattern(Reader& reader, PatternBody& body, BodyKind kind) {
  ParsedPattern parsed;
  const Word word = reader.word();
  if (word == Word::kNone) return parsed;
  if (kind != BodyKind::kFunction) reject_foreign_pattern(reader, kind);
  if (kind != BodyKind::kFunction && reader.accept(Word::kAverage)) {
    body.pattern = Average{};
    parsed.found = true;
  } else if (kind != BodyKind::kFunction && reader.accept(Word::kUvMapping)) {
    body.pattern = UvMapping{};
    parsed.found = true;
  } else {
    parsed.found = accept_from_table(reader, body, kind, spelling(word), parsed,
                                     std::make_index_sequence<std::variant_size_v<AnyPattern>>());
  }
  return parsed;
}

int list_length(const PatternBody& body) {
  const auto* pattern = std::get_if<AnyPattern>(&body.pattern);
  return pattern == nullptr ? 0 : std::visit([](const auto& p) { return p.kListLength; }, *pattern);
}

void close_list_pattern(Reader& reader, const PatternBody& body) {
  const auto* pattern = std::get_if<AnyPattern>(&body.pattern);
  if (pattern != nullptr && std::visit([](const auto& p) { return p.kKeyword == "object"; }, *pattern)) reader.close(Word::kObject);
}

bool accept_pattern_modifier(Reader& reader, PatternBody& body) {
  const Word word = reader.word();
  if (word == Word::kNone) return false;
  if (auto* pattern = std::get_if<AnyPattern>(&body.pattern))
    if (std::visit([&](auto& p) { return accept_own_modifier(reader, p); }, *pattern)) return true;
  if (at_turbulence_word(word)) return accept_turbulence_item(reader, classic_turbulence(body.warps));
  if (reader.accept(Word::kFrequency)) body.frequency = static_cast<float>(reader.number());
  else if (reader.accept(Word::kPhase)) body.phase = static_cast<float>(reader.number());
  else if (reader.accept(Word::kNoiseGenerator)) body.noise_generator |= noise_generator(reader);
  else if (reader.accept(Word::kWarp)) parse_warp(reader, body.warps);
  else if (const auto transform = accept_transformation(reader)) prepend_transform(body.warps, *transform);
  else if (!accept_wave(reader, body)) {
    reject_foreign_word(reader);
    return false;
  }
  return true;
}

void require_complete_pattern(Reader& reader, const PatternBody& body) {
  if (const auto* pattern = std::get_if<AnyPattern>(&body.pattern))
    std::visit([&](const auto& p) { check_complete(reader, p); }, *pattern);
}

bool at_color_word(Reader& reader) {
  switch (reader.word()) {
    case Word::kColor: case Word::kRgb: case Word::kRgbf: case Word::kRgbt: case Word::kRgbft:
    case Word::kSrgb: case Word::kSrgbf: case Word::kSrgbt: case Word::kSrgbft:
    case Word::kRed: case Word::kGreen: case Word::kBlue: case Word::kFilter: case Word::kTransmit: case Word::kAlpha:
      return true;
    default: {
      const Item& next = reader.peek();
      if (next.token.kind != TokenKind::kIdentifier) return false;
      const auto* number = next.slot->get_if<Number>();
      return number != nullptr && number->count == 5;
    }
  }
}

}  // namespace lute
