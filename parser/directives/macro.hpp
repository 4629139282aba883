// A macro: its parameters and where its body is. Source: specification chapter 10 §5.
#pragma once

#include <string>
#include <vector>

#include "parser/lexer/source_file.hpp"

namespace lute {

struct Macro {
  NameId name = 0;
  std::vector<NameId> parameters;
  SourceFile* file = nullptr;
  const Token* begin = nullptr;  // the body: behind the header's `)` ...
  const Token* end = nullptr;    // ... up to the `#` of its `#end`
};

}  // namespace lute
