// Advice that needs the tokens around the mistake: how the open block is written, which parenthesis is open, how a macro is called.
#pragma once

#include <string>
#include <string_view>

#include "parser/diagnostic/diagnostic.hpp"

namespace lute {

struct Item;
struct Session;

// How the object is written that a wrong value stands at the beginning of, or "".
std::string form_of_block(const Session& session, const Diagnostic& diagnostic);

// What is wrong where `expected`, a parenthesis, is missing in front of `found`, or "".
std::string about_parenthesis(Session& session, std::string_view expected, const Item& found);

}  // namespace lute
