// What follows the word of each pattern that has arguments, and the modifiers that only one pattern knows. A pattern without any
// needs no overload here.
#pragma once

#include "parser/reader.hpp"
#include "parser/statement/pattern.hpp"

namespace lute {

template <class Pattern>
void parse_arguments(Reader&, Pattern&, ParsedPattern&) {}
void parse_arguments(Reader& reader, Gradient& pattern, ParsedPattern& parsed);
void parse_arguments(Reader& reader, Spiral1& pattern, ParsedPattern& parsed);
void parse_arguments(Reader& reader, Spiral2& pattern, ParsedPattern& parsed);
void parse_arguments(Reader& reader, Mandel& pattern, ParsedPattern& parsed);
void parse_arguments(Reader& reader, Julia& pattern, ParsedPattern& parsed);
void parse_arguments(Reader& reader, Magnet& pattern, ParsedPattern& parsed);
void parse_arguments(Reader& reader, Slope& pattern, ParsedPattern& parsed);
void parse_arguments(Reader& reader, Tiling& pattern, ParsedPattern& parsed);
void parse_arguments(Reader& reader, DensityFile& pattern, ParsedPattern& parsed);
void parse_arguments(Reader& reader, FunctionPattern& pattern, ParsedPattern& parsed);
void parse_arguments(Reader& reader, PigmentPattern& pattern, ParsedPattern& parsed);
void parse_arguments(Reader& reader, ObjectPattern& pattern, ParsedPattern& parsed);  // the block stays open for the list
void parse_arguments(Reader& reader, ImageMap& pattern, ParsedPattern& parsed);
void parse_arguments(Reader& reader, ImagePattern& pattern, ParsedPattern& parsed);
void parse_arguments(Reader& reader, BumpMap& pattern, ParsedPattern& parsed);

template <class Pattern>
bool accept_own_modifier(Reader&, Pattern&) {
  return false;
}
bool accept_own_modifier(Reader& reader, Agate& pattern);
bool accept_own_modifier(Reader& reader, Brick& pattern);
bool accept_own_modifier(Reader& reader, Crackle& pattern);
bool accept_own_modifier(Reader& reader, Quilted& pattern);
bool accept_own_modifier(Reader& reader, Facets& pattern);
bool accept_own_modifier(Reader& reader, DensityFile& pattern);
bool accept_own_modifier(Reader& reader, Mandel& pattern);
bool accept_own_modifier(Reader& reader, Julia& pattern);
bool accept_own_modifier(Reader& reader, Magnet& pattern);
bool accept_own_modifier(Reader& reader, Pavement& pattern);

// What must hold once all modifiers are read.
template <class Pattern>
void check_complete(Reader&, const Pattern&) {}
void check_complete(Reader& reader, const Pavement& pattern);

}  // namespace lute
