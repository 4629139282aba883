#include "app/console.hpp"

#include <cstdio>

namespace lute {

bool Console::wanted(const Diagnostic& diagnostic) const {
  if (diagnostic.severity == Severity::kError) return options_.fatal_console;
  return options_.warning_console && options_.warning_level > 0;
}

void Console::diagnostic(const Diagnostic& diagnostic) {
  if (options_.json_diagnostics) {
    collected_.push_back(diagnostic);
  } else if (wanted(diagnostic)) {
    std::fputs(to_text(diagnostic).c_str(), stderr);
  }
}

void Console::debug(std::string_view text) const {
  if (options_.debug_console) std::fwrite(text.data(), 1, text.size(), stderr);
}

void Console::line(const std::string& text) const {
  if (options_.verbose && options_.render_console) std::fprintf(stderr, "%s\n", text.c_str());
}

void Console::error(const std::string& text) const { std::fprintf(stderr, "lute: error: %s\n", text.c_str()); }

void Console::finish(bool picture_on_stdout) {
  if (!options_.json_diagnostics) return;
  std::fprintf(picture_on_stdout ? stderr : stdout, "%s\n", to_json(collected_).c_str());
  std::fflush(stdout);
  collected_.clear();
}

}  // namespace lute
