// A file that the scene reads or writes with #fopen, #read, #write, #fclose. Source: specification chapter 10 §6.5.
#pragma once

#include <fstream>

#include "parser/lexer/source_file.hpp"

namespace lute {

struct UserFile {
  std::string name;         // as the scene gives it
  SourceFile input;         // of a file that is read: all of its tokens
  const Token* cursor = nullptr;
  std::ofstream output;     // of a file that is written
  bool reading = false;
};

}  // namespace lute
