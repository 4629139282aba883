#include "app/console.hpp"

#include <cstdio>
#include <utility>

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

void Console::failure(const std::string& code, const std::string& message, const std::string& hint) {
  if (options_.json_diagnostics) {
    Diagnostic diagnostic;
    diagnostic.code = code;
    diagnostic.message = message;
    diagnostic.hint = hint;
    collected_.push_back(std::move(diagnostic));
    return;
  }
  std::fprintf(stderr, "lute: error: %s\n", message.c_str());
  if (!hint.empty()) std::fprintf(stderr, "  %s\n", hint.c_str());
}

void Console::finish(bool picture_on_stdout) {
  if (!options_.json_diagnostics) return;
  std::fprintf(picture_on_stdout ? stderr : stdout, "%s\n", to_json(collected_).c_str());
  std::fflush(stdout);
  collected_.clear();
}

}  // namespace lute
