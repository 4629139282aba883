// Reads options from where they are given: povray.ini, INI files, switches, GNU forms. Later ones win.
//
// Source: specification chapter 30 §9.1-9.3. All mistakes are OptionErrors.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "parser/options/render_options.hpp"

namespace lute {

// What the options see of the system; tests give their own.
struct OptionEnvironment {
  std::function<std::optional<std::string>(const std::string& name)> variable;
  std::function<std::optional<std::string>(const std::string& path)> read_file;  // nothing: it does not exist

  static OptionEnvironment of_process();
};

// Built-in defaults, then povray.ini, then the arguments (without the program's name) from left to right.
RenderOptions read_options(std::span<const std::string> arguments, const OptionEnvironment& environment);

}  // namespace lute
