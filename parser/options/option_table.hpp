// The table of all options: each stands here once, with its INI keyword, its switch, its long form and what it does.
//
// The three ways to give an option: `Antialias_Depth=4` (INI file or command line), `+R4`, `--antialias-depth 4`. A row
// with a keyword and no long form has the keyword in lower case with hyphens; booleans also have `--no-...`. Source:
// specification chapter 30 §9.3.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "parser/options/render_options.hpp"

namespace lute {

// What an option's value is. Words that stand directly behind a switch follow the same rule.
enum class ValueKind : std::uint8_t {
  kNone,     // an action: `--help`
  kBoolean,  // `+`, `on`, `--name`; `-`, `off`, `--no-name`
  kInteger,
  kFloat,
  kText,
  kCommand,  // the raw rest of an INI line
};

// What may stand behind a switch beside the sign.
enum class SwitchTail : std::uint8_t {
  kNothing,           // +UA
  kInteger,           // +W800
  kFloat,             // +K0.5
  kText,              // +Iscene.pov
  kOptionalFloat,     // +J, +J0.5
  kOptionalFraction,  // +A, +A0.3: nothing but 0.n
  kOptionalInteger,   // +X, +X10
  kOptionalText,      // +GA, +GAfile
};

struct OptionValue {
  bool on = true;     // of a boolean; of a switch, its sign
  std::string text;   // as written
  double number = 0;  // of floats, and of the number behind a boolean switch
  int integer = 0;
  bool has_tail = false;  // a boolean with a value of its own: +A0.3, `--antialias 0.3`
};

struct OptionRow {
  std::string_view keyword;      // INI; "": none
  std::string_view switch_name;  // behind + or -; "": none
  std::string_view long_name;    // behind --; "": from the keyword
  ValueKind kind;
  SwitchTail tail;
  void (*apply)(RenderOptions&, const OptionValue&);  // null: accepted, without effect
  std::string_view help;
};

std::span<const OptionRow> option_table();

// `antialias-depth`: what stands behind --; "" where the option has no long form.
std::string long_name_of(const OptionRow& row);

// The text of `lute --help`.
std::string option_help();

}  // namespace lute
