// Reads a scene text that the test holds, and gives back what it printed with #debug and what was said about it.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

#include "parser/parse.hpp"

namespace lute::test {

struct Reading {
  bool ok = false;
  std::string printed;  // complete #debug lines
  std::vector<Diagnostic> diagnostics;

  // The first error: the one that POV-Ray stops at.
  const Diagnostic* first_error() const {
    const auto found = std::ranges::find(diagnostics, Severity::kError, &Diagnostic::severity);
    return found == diagnostics.end() ? nullptr : &*found;
  }
  std::string error() const { return first_error() == nullptr ? "" : first_error()->message; }
  const Diagnostic& last() const { return diagnostics.back(); }
};

// `#version 3.7; global_settings { assumed_gamma 1 }` stand on the first line, the text begins on the second.
inline Reading read_text(std::string_view text, ParseOptions options = {}) {
  Reading reading;
  options.input_file = "test.pov";
  options.input_text = "#version 3.7; global_settings { assumed_gamma 1 }\n" + std::string(text);
  // Files of tests are there.
  const std::string temporary = std::filesystem::temp_directory_path().string();
  options.allow_read.push_back(temporary);
  options.allow_write.push_back(temporary);
  options.on_debug = [&](std::string_view line) { reading.printed += line; };
  const ParseResult result = parse_scene(options);
  reading.ok = result.ok;
  reading.diagnostics = result.diagnostics;
  return reading;
}

// The value of a float expression, printed by the scene itself.
inline std::string float_text(std::string_view expression, int digits = 12) {
  const std::string value = "#debug concat(str(" + std::string(expression) + ",0," + std::to_string(digits) + "),\"\\n\")\n";
  const Reading reading = read_text(value);
  return reading.ok ? reading.printed.substr(0, reading.printed.size() - 1) : "error: " + reading.error();
}

// `count` components of a vector expression, six digits each.
inline std::string vector_text(std::string_view expression, int count = 3) {
  const Reading reading = read_text("#debug concat(vstr(" + std::to_string(count) + "," + std::string(expression) +
                                    ",\",\",0,6),\"\\n\")\n");
  return reading.ok ? reading.printed.substr(0, reading.printed.size() - 1) : "error: " + reading.error();
}

inline std::string printed(std::string_view text) {
  const Reading reading = read_text(text);
  return reading.ok ? reading.printed : "error: " + reading.error();
}

inline std::string error_of(std::string_view text) { return read_text(text).error(); }

}  // namespace lute::test
