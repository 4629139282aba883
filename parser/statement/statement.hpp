// What the language core needs from the statement parsers.
#pragma once

#include <functional>
#include <memory>
#include <unordered_map>

#include "parser/reader.hpp"

namespace lute {

// What statements keep during a parse (current defaults, ...): derive from it.
class StatementState {
 public:
  virtual ~StatementState() = default;
};
std::unique_ptr<StatementState> make_statement_state();

// Reads one top-level statement if the next token starts one; false (and nothing taken) if it does not.
bool parse_statement(Reader& reader);

// The word can begin a statement: an object, a camera, a setting, ...
bool begins_top_level_statement(Word word);

// `#default { ... }`: the keyword was taken.
void parse_default(Reader& reader);

// End-of-parse actions and warnings, after the last statement.
void finish_scene(Reader& reader);

// The right-hand sides of #declare, macro arguments and array elements that statements know: keyword -> parser. The keyword is
// the next token and not yet taken. `pattern` (only inside `function { pattern { ... } }`) gives a PigmentPtr whose body counts.
using DeclareValues = std::unordered_map<Word, std::function<Value(Reader&)>>;
DeclareValues make_declare_values();

}  // namespace lute
