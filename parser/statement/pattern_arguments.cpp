#include "parser/statement/pattern_arguments.hpp"

#include <cmath>
#include <string>

#include "parser/statement/object.hpp"
#include "parser/statement/object_edit.hpp"
#include "parser/statement/pigment.hpp"
#include "parser/statement/transformation.hpp"

namespace lute {
namespace {

float real(Reader& reader) { return static_cast<float>(reader.number()); }

}  // namespace

void parse_arguments(Reader& reader, Gradient& pattern, ParsedPattern&) {
  const dvec3 direction = reader.vector();
  double length = glm::length(direction);
  if (!(length > 1e-150 && length < 1e150)) length = std::hypot(direction.x, direction.y, direction.z);  // whose squares are 0 or infinite
  pattern.direction = length > 0 ? direction / length : direction;
}

// 16 bits of the number of arms count.
void parse_arguments(Reader& reader, Spiral1& pattern, ParsedPattern&) { pattern.arms = static_cast<std::int16_t>(reader.integer()); }
void parse_arguments(Reader& reader, Spiral2& pattern, ParsedPattern&) { pattern.arms = static_cast<std::int16_t>(reader.integer()); }

// slope V, or slope { [point_at] V [, lo [, hi]] [altitude A [, lo [, hi]]] }
void parse_arguments(Reader& reader, Slope& pattern, ParsedPattern&) {
  const auto range = [&](double& low, double& high) {
    reader.comma();
    low = high = 0;
    if (const auto first = reader.optional_number()) low = *first;
    reader.comma();
    if (const auto second = reader.optional_number()) high = *second;
    if (low == high && low != 0) {
      reader.warning("Slope range with equal ends is ignored.");
      low = high = 0;
    }
  };
  if (!reader.at(TokenKind::kLeftBrace)) {
    pattern.vector = reader.vector();
  } else {
    reader.open(Word::kSlope);
    pattern.point_at = reader.accept(Word::kPointAt);
    pattern.vector = reader.vector();
    range(pattern.low, pattern.high);
    if (reader.accept(Word::kAltitude)) {
      if (pattern.point_at) reader.error("Keyword 'altitude' cannot be used with 'point_at' in slope pattern.");
      pattern.altitude = reader.vector();
      range(pattern.altitude_low, pattern.altitude_high);
    }
    reader.close(Word::kSlope);
  }
  if (pattern.vector == dvec3(0) && pattern.altitude == dvec3(0) && !pattern.point_at)
    reader.error("Zero length for both slope and gradient.");
}

void parse_arguments(Reader& reader, DensityFile& pattern, ParsedPattern&) {
  reader.expect(Word::kDf3);
  const std::string name = reader.file_name();
  const auto path = reader.find_file(name, {".df3", ".DF3"});
  if (!path) reader.error("Cannot open density file " + name + ".", "missing-file");
  std::string error;
  pattern.volume = DensityVolume::load(*path, error);
  if (pattern.volume == nullptr) reader.error(error, "bad-file");
}

void parse_arguments(Reader& reader, FunctionPattern& pattern, ParsedPattern&) {
  pattern.function = reader.float_function();
}

void parse_arguments(Reader& reader, PigmentPattern& pattern, ParsedPattern&) {
  reader.open(Word::kPigmentPattern);
  pattern.pigment = parse_pigment_items(reader, std::make_shared<const Pigment>(), BodyKind::kPigment);
  reader.close(Word::kPigmentPattern);
}

void parse_arguments(Reader& reader, ObjectPattern& pattern, ParsedPattern&) {
  reader.open(Word::kObject);
  auto object = accept_object(reader);
  if (!object) reader.error_expected("object");
  while (const auto transform = accept_transformation(reader)) object = transformed(*object, *transform);
  pattern.object = *object;
}

bool accept_own_modifier(Reader& reader, Facets& pattern) {
  if (reader.accept(Word::kSize)) pattern.size = real(reader);
  else if (reader.accept(Word::kCoords)) pattern.coords = real(reader);
  else if (reader.accept(Word::kMetric)) pattern.metric = reader.vector().x;
  else return false;
  return true;
}

bool accept_own_modifier(Reader& reader, DensityFile& pattern) {
  if (!reader.accept(Word::kInterpolate)) return false;
  pattern.interpolate = reader.integer();
  return true;
}

bool accept_own_modifier(Reader& reader, Agate& pattern) {
  if (!reader.accept(Word::kAgateTurb)) return false;
  pattern.turbulence = real(reader);
  return true;
}

bool accept_own_modifier(Reader& reader, Brick& pattern) {
  if (reader.accept(Word::kBrickSize)) pattern.size = reader.vector();
  else if (reader.accept(Word::kMortar)) pattern.mortar = static_cast<float>(reader.number() - 2 * kEpsilon);
  else return false;
  return true;
}

bool accept_own_modifier(Reader& reader, Crackle& pattern) {
  if (reader.accept(Word::kForm)) pattern.form = reader.vector();
  else if (reader.accept(Word::kMetric)) pattern.metric = reader.vector().x;
  else if (reader.accept(Word::kOffset)) pattern.offset = reader.number();
  else if (reader.accept(Word::kSolid)) pattern.solid = reader.optional_flag();
  else return false;
  return true;
}

bool accept_own_modifier(Reader& reader, Quilted& pattern) {
  if (reader.accept(Word::kControl0)) pattern.control0 = real(reader);
  else if (reader.accept(Word::kControl1)) pattern.control1 = real(reader);
  else return false;
  return true;
}

}  // namespace lute
