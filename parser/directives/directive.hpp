// The directives, one function each; the `#` and the keyword were taken. Source: specification chapter 10 §2-§6.
#pragma once

#include "parser/session.hpp"

namespace lute {

// Executes the directive whose `#` is next in the innermost frame. Without a directive behind it the `#` is passed over.
void run_directive(Session& session);

// conditional.cpp
void run_if(Session& session);
void begin_if(Session& session, bool condition);  // behind the condition
void run_ifdef(Session& session, bool wanted);
void run_elseif(Session& session);
void run_else(Session& session);
void run_switch(Session& session);
void run_case(Session& session, Word word);
bool is_defined(Session& session);  // NAME or NAME[subscripts] next: ifdef and defined()

// loop.cpp
void run_while(Session& session);
void repeat_for(Session& session);  // the next turn of the innermost conditional, a #for; the cursor is behind its #end
void run_for(Session& session);
void run_end(Session& session);
void run_break(Session& session);

// skip.cpp: from the innermost frame's cursor to the next directive of the own level. Its keyword is taken and returned.
// `to_end`: only #end counts. `macro`: the keyword, if this is the body of a #macro.
Word skip(Session& session, bool to_end, const Token* macro = nullptr);

// macro.cpp
void run_macro(Session& session);  // the definition
void call_macro(Session& session, const MacroPtr& macro, const Item& name);

// include.cpp
void run_include(Session& session);
void include_file(Session& session, const std::string& name);
void run_version(Session& session);

// declare.cpp
void run_declare(Session& session, bool local);
void run_undef(Session& session);
// To a variable, or to the array element that a macro parameter stands for: `depth` arrays in each other are around it.
void assign(Session& session, Value& target, Value value, int depth = 0);
// What may stand on the right of `=` in #declare, as a macro argument (`argument`: lone identifiers are passed by reference), or
// as an array element.
struct ParsedValue {
  Slot slot;               // by reference if it is a variable's own
  bool by_reference = false;
  bool numeric = false;    // needs `;` in #declare
  std::uint8_t depth = 0;  // by reference: as of Item
};
enum class ValueUse : std::uint8_t { kDeclare, kArgument, kElement };
ParsedValue parse_value(Session& session, ValueUse use);
Value parse_array(Session& session);  // the keyword was taken
// The index of the element that `[...]...` selects; the `[` is next in the raw stream.
std::size_t select_element(Session& session, const Array& array, std::uint16_t& subscripts);
// What the subscripts that are written behind a declared name select: also an element without a value. No array: there are none.
struct WrittenElement {
  ArrayPtr array;
  std::size_t index = 0;
  std::uint8_t depth = 0;  // as of Item
};
WrittenElement written_element(Session& session, const Item& name);

// text_stream.cpp
void run_text_stream(Session& session, Word word);
void run_error(Session& session);

// user_file.cpp
void run_fopen(Session& session);
void run_fclose(Session& session);
void run_read(Session& session);
void run_write(Session& session);

// The open parenthesis and the closing one around a directive's argument.
void open_paren(Session& session);
void close_paren(Session& session);

}  // namespace lute
