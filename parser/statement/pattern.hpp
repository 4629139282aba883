// Patterns as pigment, normal, density, texture and `function { pattern { ... } }` share them: the pattern's word with its
// arguments, and the modifiers that work on every body.
// Source: specification chapters 11 §10 and 50.
#pragma once

#include <cstdint>
#include <optional>

#include "parser/reader.hpp"

namespace lute {

enum class BodyKind : std::uint8_t { kPigment, kNormal, kDensity, kTexture, kFunction };

struct ParsedPattern {
  bool found = false;
  std::optional<float> bump_size;  // written inside of bump_map {}
};

// Reads a pattern's word and arguments into `body` if one comes next; the items of a list pattern are left to the caller, who then
// calls close_list_pattern(). `average` and `uv_mapping` count as patterns.
ParsedPattern accept_pattern(Reader& reader, PatternBody& body, BodyKind kind);
void close_list_pattern(Reader& reader, const PatternBody& body);

// How many items a list pattern has; 0 for other patterns.
int list_length(const PatternBody& body);

// turbulence, frequency, waves, warps, transformations, and what belongs to one pattern only; false if none of these comes next.
bool accept_pattern_modifier(Reader& reader, PatternBody& body);

// Stops where the modifiers, all read now, do not fit together.
void require_complete_pattern(Reader& reader, const PatternBody& body);

// A colour as pigments begin with it: a colour word or an identifier that holds a colour, no bare number or vector.
bool at_color_word(Reader& reader);

}  // namespace lute
