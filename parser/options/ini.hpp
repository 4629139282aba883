// The grammar of INI files, in Boost.Spirit X3: lines of `Keyword = value`, `[section]`, switches or file names, and
// comments from
// `;` or `#`. Source: specification chapter 30 §9.1.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lute {

struct IniLine {
  int number = 0;                   // from 1
  std::string keyword;              // "": `values` are switches and file names
  std::vector<std::string> values;  // unquoted; a list `a,b` gives several
  std::string raw;                  // the rest of the line behind `=` up to a comment, for shell commands
};

struct IniSection {
  std::string name;  // "" for what comes before the first header
  std::vector<IniLine> lines;
};

// `file_name` is for messages. Throws OptionError.
std::vector<IniSection> parse_ini(std::string_view text, std::string_view file_name);

}  // namespace lute
