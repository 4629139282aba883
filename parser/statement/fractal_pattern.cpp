// mandel, julia and magnet as patterns (specification chapters 11 §10.2 and 50 §6.6).
#include "parser/statement/pattern_arguments.hpp"

namespace lute {
namespace {

bool accept_coloring(Reader& reader, FractalSettings& pattern) {
  if (reader.accept(Word::kExterior)) {
    pattern.exterior_type = reader.integer();
    if (pattern.exterior_type < 0 || pattern.exterior_type > 8) reader.error("Invalid fractal pattern exterior type. Valid types are 0 to 8.");
    reader.comma();
    pattern.exterior_factor = reader.number();
  } else if (reader.accept(Word::kInterior)) {
    pattern.interior_type = reader.integer();
    if (pattern.interior_type < 0 || pattern.interior_type > 6) reader.error("Invalid fractal pattern interior type. Valid types are 0 to 6.");
    reader.comma();
    pattern.interior_factor = reader.number();
  } else {
    return false;
  }
  return true;
}

bool accept_exponent(Reader& reader, int& exponent) {
  if (!reader.accept(Word::kExponent)) return false;
  exponent = reader.integer();
  if (exponent < 2 || exponent > 33) {
    reader.warning("Invalid exponent of a fractal pattern: 2 is used.");
    exponent = 2;
  }
  return true;
}

void parse_julia(Reader& reader, dvec2& constant, int& iterations) {
  constant = reader.vector2();
  reader.comma();
  iterations = reader.integer();
}

}  // namespace

void parse_arguments(Reader& reader, Mandel& pattern, ParsedPattern&) { pattern.iterations = reader.integer(); }

void parse_arguments(Reader& reader, Julia& pattern, ParsedPattern&) { parse_julia(reader, pattern.c, pattern.iterations); }

void parse_arguments(Reader& reader, Magnet& pattern, ParsedPattern&) {
  pattern.type = reader.integer();
  if (pattern.type != 1 && pattern.type != 2) reader.error("Invalid magnet-mandel pattern type found. Valid types are 1 and 2.");
  if (reader.accept(Word::kMandel)) {
    pattern.iterations = reader.integer();
  } else if (reader.accept(Word::kJulia)) {
    dvec2 constant;
    parse_julia(reader, constant, pattern.iterations);
    pattern.julia = constant;
  } else {
    reader.error("Invalid magnet pattern found. Valid types are 'mandel' and 'julia'.");
  }
}

bool accept_own_modifier(Reader& reader, Mandel& pattern) {
  return accept_exponent(reader, pattern.exponent) || accept_coloring(reader, pattern);
}
bool accept_own_modifier(Reader& reader, Julia& pattern) {
  return accept_exponent(reader, pattern.exponent) || accept_coloring(reader, pattern);
}
bool accept_own_modifier(Reader& reader, Magnet& pattern) { return accept_coloring(reader, pattern); }

}  // namespace lute
