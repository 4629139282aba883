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
  void error(const std::string& text) const;

  // The collected diagnostics as JSON, if that form is wanted: on standard output, or on standard error where the
  // picture goes there.
  void finish(bool picture_on_stdout);

 private:
  bool wanted(const Diagnostic& diagnostic) const;

  const RenderOptions& options_;
  std::vector<Diagnostic> collected_;
};

}  // namespace lute
