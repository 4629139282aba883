// Where reading goes on after an error: the first token behind it at which a new statement or directive can begin.
//
// Two signs are used. Braces: the statement ends with the brace that closes its block. Indentation, where braces are missing: a
// line that does not stand further right than the statement's own and begins with something that begins statements. Braces
// count for more if the closing one stands where a closing brace of this statement would be written.
#pragma once

#include <functional>
#include <vector>

#include "parser/lexer/source_file.hpp"

namespace lute {

struct BrokenStatement {
  const SourceFile* file = nullptr;
  const Token* start = nullptr;  // its first token
  const Token* error = nullptr;  // what could not be read; not in front of `start`
  const Token* end = nullptr;    // behind the last token that may be looked at
  std::function<bool(const Token&)> begins_statement;  // of words and names
};

struct ResumePoint {
  const Token* token = nullptr;
  bool lost = false;          // nothing that looks like a new statement: `token` is the end
  std::vector<NameId> names;  // declared by the text that is left out
};

ResumePoint find_resume_point(const BrokenStatement& broken);

}  // namespace lute
