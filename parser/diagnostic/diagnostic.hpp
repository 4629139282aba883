// What the parser tells about a scene: warnings, possible errors and the fatal error that ends it, each with its place, the
// line it is on, the chain of includes and macro calls that led there, and a hint where one is known.
// Source: specification chapter 10 §13.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/source_location.hpp"

namespace lute {

enum class Severity : std::uint8_t { kWarning, kPossibleError, kError };

std::string_view name_of(Severity severity);  // "warning", "possible error", "error"

// One step of the way to the place: "in macro Tree, called from" or "included from".
struct DiagnosticNote {
  std::string text;
  std::string file;
  SourceLocation where;
};

struct Diagnostic {
  Severity severity = Severity::kError;
  std::string code;             // stable, for programs: "expected-token", "undeclared-identifier", ...
  std::string file;             // name of the file as it was found
  SourceLocation where;
  std::uint32_t end_column = 0;  // one past the last byte of what is marked
  std::string message;          // one line, no full stop added
  std::string hint;             // "" or for example "did you mean 'sphere'?"
  std::string excerpt;          // the source line, without its line end; "" where there is none
  std::vector<DiagnosticNote> chain;  // innermost first
};

// Ends the parse. Thrown with the complete diagnostic.
class SceneError : public std::runtime_error {
 public:
  explicit SceneError(Diagnostic diagnostic);
  const Diagnostic& diagnostic() const { return diagnostic_; }

 private:
  Diagnostic diagnostic_;
};

// Collects diagnostics and passes each on as it comes. More than `limit` non-fatal ones are counted, not kept.
class DiagnosticSink {
 public:
  using Listener = std::function<void(const Diagnostic&)>;
  explicit DiagnosticSink(Listener listener = {}, std::size_t limit = 1000) : listener_(std::move(listener)), limit_(limit) {}

  void report(Diagnostic diagnostic);
  const std::vector<Diagnostic>& all() const { return all_; }
  std::size_t suppressed() const { return suppressed_; }

 private:
  Listener listener_;
  std::size_t limit_;
  std::size_t suppressed_ = 0;
  std::vector<Diagnostic> all_;
};

// file:line:column: severity: message, the source line, a caret line, the chain, the hint. Ends with a newline.
std::string to_text(const Diagnostic& diagnostic);

// A JSON array of objects {severity, code, file, line, column, endColumn, message, hint, chain: [...]}.
std::string to_json(std::span<const Diagnostic> diagnostics);

// The candidate nearest to `name` in edit distance, if near enough to be a slip; else "". One that differs in case only is the nearest;
// of equally near ones the first counts.
std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace lute
