// tiling and pavement as patterns (specification chapter 11 §10).
#include <string>

#include "parser/statement/pattern_arguments.hpp"

namespace lute {

void parse_arguments(Reader& reader, Tiling& pattern, ParsedPattern&) {
  pattern.number = reader.integer();
  if (pattern.number < 1 || pattern.number > 27) reader.error("Tiling number must be between 1 and 27.");
}

bool accept_own_modifier(Reader& reader, Pavement& pattern) {
  if (reader.accept(Word::kNumberOfSides)) pattern.sides = reader.integer();
  else if (reader.accept(Word::kNumberOfTiles)) pattern.tiles = reader.integer();
  else if (reader.accept(Word::kPattern)) pattern.pattern = reader.integer();
  else if (reader.accept(Word::kForm)) pattern.form = reader.integer();
  else if (reader.accept(Word::kInterior)) pattern.interior = reader.integer();
  else if (reader.accept(Word::kExterior)) pattern.exterior = reader.integer();
  else return false;
  return true;
}

void check_complete(Reader& reader, const Pavement& pattern) {
  if (pattern.sides != 3 && pattern.sides != 4 && pattern.sides != 6) reader.error("number_of_sides of pavement must be 3, 4 or 6.");
  const int patterns = pavement_pattern_count(pattern.sides, pattern.tiles);
  std::string limits;  // of the pattern, for each number of tiles
  int tiles = 0;
  while (const int most = pavement_pattern_count(pattern.sides, tiles + 1)) {
    limits += (tiles == 0 ? "" : ",") + std::to_string(most);
    ++tiles;
  }
  if (patterns == 0) reader.error("number_of_tiles of pavement must be between 1 and " + std::to_string(tiles) + ".");
  if (pattern.pattern < 1 || pattern.pattern > patterns) reader.error("pattern value for pavement is out of range. max per tile:(" + limits + ")");
}

}  // namespace lute
