#include "parser/diagnostic/context_advice.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>

#include "parser/diagnostic/blank.hpp"
#include "parser/diagnostic/block_words.hpp"

namespace lute {

namespace {

// The line of the mistake: the marked text and what stands around it without blanks between.
struct Place {
  std::string_view before, found, after;
  bool blank_before = false;
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

Place place_of(const Diagnostic& d) {
  Place place;
  const std::string_view line = d.excerpt;
  if (d.where.column == 0 || d.where.column > line.size()) {
    place.before = line;
    return place;
  }
  const std::size_t begin = d.where.column - 1;
  const std::size_t end = std::clamp<std::size_t>(d.end_column - 1, begin + 1, line.size());
  place.before = line.substr(0, begin);
  place.found = line.substr(begin, end - begin);
  place.after = line.substr(end);
  place.blank_before = begin > 0 && is_blank(line[begin - 1]);
  while (!place.before.empty() && is_blank(place.before.back())) place.before.remove_suffix(1);
  while (!place.after.empty() && is_blank(place.after.front())) place.after.remove_prefix(1);
  return place;
}

// Where a word of elsewhere stands if it means what it does there.
enum class Where : std::uint8_t { kAnywhere, kStatement, kExpression, kCondition, kFor, kMacro, kCamera };

struct ForeignWord {
  std::string_view word, hint;
  Where where = Where::kAnywhere;
};

constexpr std::string_view kDeclare = "constants and variables are made by #declare NAME = VALUE;";
constexpr std::string_view kFor = "the parts of #for stand behind commas: #for (NAME, START, END, STEP)";
constexpr std::string_view kVector = "a vector is written <x, y, z>";
constexpr std::string_view kEnd = "#if, #while, #for, #switch and #macro all end with #end";

// Of other languages and programs, and of everyday speech.
constexpr ForeignWord kForeign[] = {
    {"define", kDeclare, Where::kStatement},
    {"set", kDeclare, Where::kStatement},
    {"let", kDeclare, Where::kStatement},
    {"var", kDeclare, Where::kStatement},
    {"const", kDeclare, Where::kStatement},
    {"float", kDeclare, Where::kStatement},
    {"int", kDeclare, Where::kStatement},
    {"double", kDeclare, Where::kStatement},
    {"vector", kDeclare, Where::kStatement},
    {"endif", kEnd, Where::kStatement},
    {"endmacro", kEnd, Where::kStatement},
    {"endwhile", kEnd, Where::kStatement},
    {"endfor", kEnd, Where::kStatement},
    {"endswitch", kEnd, Where::kStatement},
    {"enddef", kEnd, Where::kStatement},
    {"elif", "write #elseif (CONDITION)", Where::kStatement},
    {"and", "'and' is written &", Where::kExpression},
    {"or", "'or' is written |", Where::kExpression},
    {"not", "'not' is written !", Where::kExpression},
    {"then", "a condition stands in parentheses, and nothing behind it: #if (A = B)", Where::kCondition},
    {"to", kFor, Where::kFor},
    {"return", "what a macro's body leaves is its value: #macro Twice(A) 2*A #end", Where::kMacro},
    {"fov", "the angle of view is written angle DEGREES", Where::kCamera},
    {"PI", "write pi"},
};

// The parenthesis of a #for is open.
bool is_inside_for(std::string_view before) {
  const std::size_t directive = before.rfind("#for");
  if (directive == std::string_view::npos) return false;
  before.remove_prefix(directive);
  return std::ranges::count(before, '(') > std::ranges::count(before, ')');
}

bool is_inside_macro(const Diagnostic& d, const Place& place) {
  const auto is_call = [](const DiagnosticNote& note) { return note.text.starts_with("in macro"); };
  return std::ranges::any_of(d.chain, is_call) || place.before.find("#macro") != std::string_view::npos;
}

bool stands(Where where, const Diagnostic& d, const Place& place) {
  const std::string_view message = d.message;
  const bool in_block = message.starts_with("No matching }");
  const bool begins_statement = message.starts_with("Expected 'object or directive'");
  switch (where) {
    case Where::kAnywhere: return true;
    case Where::kStatement: return place.before.ends_with('#') || !in_block;
    case Where::kExpression: return !in_block && !begins_statement;
    case Where::kCondition:
      return place.before.find("#if") != std::string_view::npos || place.before.find("#elseif") != std::string_view::npos;
    case Where::kFor: return is_inside_for(place.before);
    case Where::kMacro: return is_inside_macro(d, place);
    case Where::kCamera: return message.starts_with("No matching } in 'camera'");
  }
  return false;
}

std::string foreign_word(const Diagnostic& d, const Place& place, std::string_view word) {
  const auto found = std::ranges::find(kForeign, word, &ForeignWord::word);
  return found == std::end(kForeign) || !stands(found->where, d, place) ? "" : std::string(found->hint);
}

std::string_view first_word(std::string_view text) {
  const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  return text.substr(0, static_cast<std::size_t>(std::ranges::find_if_not(text, in_word) - text.begin()));
}

// "R = 2;" without #declare.
std::string about_assignment(const Diagnostic& d, const Place& place) {
  const bool assigns = place.after.starts_with('=') && !place.after.starts_with("==");
  if (!assigns || !d.message.starts_with("Expected 'object or directive'")) return "";
  return "a value is given by #declare " + std::string(place.found) + " = VALUE;";
}

std::string about_name(const Diagnostic& d, const Place& place) {
  if (std::string hint = foreign_word(d, place, place.found); !hint.empty()) return hint;
  if (!place.blank_before && !place.before.empty() && is_digit(place.before.back())) return "numbers have no units and no suffixes";
  const bool hash = place.before.ends_with('#');
  const bool hexadecimal = std::ranges::all_of(place.found, [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; });
  if (hash && hexadecimal && place.found.size() == 6) {
    return "a colour is written srgb <r, g, b> with parts from 0 to 1: each pair of digits / 255";
  }
  if (std::string hint = about_assignment(d, place); !hint.empty()) return hint;
  if (hash && d.hint.empty()) return "# begins a directive such as #declare, #include, #if; a comment begins with //";
  if (d.hint.empty() && d.message.starts_with("No matching }")) {
    return "nothing of this name is declared: is it misspelt, or an #include missing?";
  }
  return "";
}

std::string about_byte(const Diagnostic& d) {
  const std::string_view rest = std::string_view(d.excerpt).substr(std::min<std::size_t>(d.where.column - 1, d.excerpt.size()));
  for (const std::string_view quote : {"“", "”", "„", "‘", "’", "«", "»"}) {
    if (rest.starts_with(quote)) return "strings stand in straight double quotes: \"...\"";
  }
  for (const std::string_view dash : {"–", "—", "−"}) {
    if (rest.starts_with(dash)) return "this is a typographer's dash: a minus is written -";
  }
  if (rest.starts_with("\u00A0")) return "this is a blank that keeps lines together: write a plain one";
  if (rest.starts_with("°")) return "angles are in degrees without a sign";
  return "";
}

// Values that are written as elsewhere.
std::string about_operator(const Diagnostic& d, const Place& place) {
  const std::string_view message = d.message;
  if (message.starts_with("Expected") && !message.starts_with("Expected 'undeclared") && is_inside_for(place.before)) {
    return std::string(kFor);
  }
  if (message.starts_with("Expected '('")) {
    for (const std::string_view directive : {"#ifdef", "#ifndef"}) {
      const bool names = place.before.ends_with(directive) && !first_word(place.found).empty();
      if (names) return std::string(directive) + " (" + std::string(place.found) + ")";
    }
  }
  constexpr std::string_view kPower = "a power is written pow(BASE, EXPONENT)";
  if (message.starts_with("All #declares of float")) {
    const std::string_view next = place.found.empty() || is_blank(place.found.front()) ? place.after : place.found;
    if (next.starts_with('^')) return std::string(kPower);
    if (next.starts_with('%')) return "a remainder is written mod(A, B)";
    return foreign_word(d, place, first_word(next));
  }
  if (place.found == "^") return std::string(kPower);
  if (place.found == "*" && place.before.ends_with('*')) return std::string(kPower);
  if (place.found == ">" && place.before.ends_with('<')) return "'not equal' is written !=";
  if (place.found == "+" && place.before.ends_with('"')) return "strings are joined by concat(A, B)";
  if (place.found == "<" && place.after.starts_with("!--")) return "a comment begins with //, or stands between /* and */";
  if (place.found == "[" && message.starts_with("No matching }")) return "only arrays have elements: #declare A = array[3] { 1, 2, 3 }";
  if (place.found == "[" && message.starts_with("Expected 'RValue")) return "an array is written array[3] { 1, 2, 3 }";
  if (place.found == "[" && message.starts_with("Expected")) return std::string(kVector);
  return "";
}

// "texture" in "No matching } in 'pigment', texture identifier found instead"
std::string_view type_of_found(std::string_view message) {
  const std::size_t end = message.find(" identifier found instead"), begin = message.rfind(", ", end);
  if (end == std::string_view::npos || begin == std::string_view::npos) return "";
  const std::string_view type = message.substr(begin + 2, end - begin - 2);
  return type.find_first_of("' ") == std::string_view::npos ? type : "";
}

// What ends a block that has no `}` yet.
std::string about_item(const Diagnostic& d, const Place& place) {
  const std::string_view message = d.message;
  if (!message.starts_with("No matching } in") || message.starts_with("No matching } in 'array'")) return "";
  if (place.found == "," && !place.after.empty() && (is_digit(place.after.front()) || place.after.front() == '-')) {
    return std::string(kVector) + ", and the decimal point is a dot";
  }
  for (const std::string_view block : {"finish", "interior"}) {
    if (message.starts_with("No matching } in 'global_settings'") || !is_block_word(block, place.found)) continue;
    return "it belongs inside " + std::string(block) + " { ... }";
  }
  const std::string_view type = type_of_found(message);
  if (type == "colour") return "a colour stands inside pigment { ... }";
  for (const std::string_view block : {"object", "texture", "pigment", "normal", "finish", "interior", "material", "camera", "media"}) {
    if (type == block) return "a declared " + std::string(block) + " is used as " + std::string(block) + " { NAME }";
  }
  if (message.find("'float constant' found") != std::string_view::npos) {
    return "no number belongs here: vectors are written <x, y, z>, and transformations take one: rotate 90*y";
  }
  return "";
}

}  // namespace

std::string context_advice(const Diagnostic& d) {
  if (d.message.starts_with("Illegal character")) return about_byte(d);
  const Place place = place_of(d);
  const bool name = d.message.find("undeclared identifier '") != std::string::npos || d.message.starts_with("Cannot assign uninit");
  if (name) {
    if (std::string hint = about_name(d, place); !hint.empty()) return hint;
  }
  const bool identifier = d.message.find("identifier") != std::string::npos;
  if (!name && identifier) {
    if (std::string hint = about_assignment(d, place); !hint.empty()) return hint;
  }
  if (std::string hint = about_operator(d, place); !hint.empty()) return hint;
  if (place.found == "}" && d.message.starts_with("Expected 'numeric expression'")) {
    for (const std::string_view part : {"red", "green", "blue"}) {
      if (!place.before.ends_with(part)) continue;
      return std::string(part) + " is a part of a colour and needs a number; the names of colors.inc begin with a capital letter";
    }
  }
  return about_item(d, place);
}

}  // namespace lute
