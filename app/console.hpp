// What lute says about a scene on standard error: diagnostics, #debug text, summaries; or diagnostics as JSON.
#pragma once

#include <string_view>
#include <vector>

#include "parser/options/render_options.hpp"
#include "parser/parse.hpp"

namespace lute {

class Console {
 public:
  explicit Console(const RenderOptions& options) : options_(options) {}

  void diagnostic(const Diagnostic& diagnostic);
  void debug(std::string_view text) const;
  void line(const std::string& text) const;  // only when verbose
  // What is wrong with the call or the machine, not with a place in the scene. `code`: as in Diagnostic.
  void failure(const std::string& code, const std::string& message, const std::string& hint = "");

  // The collected diagnostics as JSON, if that form is wanted: on standard output, or on standard error where the
  // picture goes there.
  void finish(bool picture_on_stdout);

 private:
  bool wanted(const Diagnostic& diagnostic) const;

  const RenderOptions& options_;
  std::vector<Diagnostic> collected_;
};

}  // namespace lute
