// #debug #warning #error #render #statistics. Source: specification chapter 10 §6.4.
#include "parser/directives/directive.hpp"
#include "parser/expression/expression.hpp"

namespace lute {

namespace {

// Long texts are cut as the reference cuts them; the line end in the tail is lost with it.
std::string cut(std::string text, std::size_t longest, std::size_t kept) {
  if (text.size() > longest) text = text.substr(0, kept) + "...";
  return text;
}

void debug(Session& session, const std::string& text) {
  session.debug_line += cut(text, 200, 156);
  const std::size_t end = session.debug_line.rfind('\n');
  if (end == std::string::npos) return;
  if (session.recovery.any()) return session.debug_line.clear();
  if (session.options.on_debug) session.options.on_debug(std::string_view(session.debug_line).substr(0, end + 1));
  session.debug_line.erase(0, end + 1);
}

}  // namespace

void run_text_stream(Session& session, Word word) {
  const Token* const keyword = session.stream.last_token;
  const std::uint32_t file = session.stream.last_file;
  const std::string text = to_bytes(session, parse_string(session));
  session.stream.last_token = keyword;
  session.stream.last_file = file;
  if (word == Word::kWarning) {
    session.warn(cut(text, 160, 124), "warning-directive");
    return;
  }
  if (word == Word::kRender || word == Word::kStatistics) {
    session.warn("#render and #statistics streams are no longer available. Redirecting output to #debug stream.", "text-stream");
  }
  debug(session, text);
}

void run_error(Session& session) {
  const Token* const keyword = session.stream.last_token;
  const std::uint32_t file = session.stream.last_file;
  const std::string text = to_bytes(session, parse_string(session));
  session.stream.last_token = keyword;
  session.stream.last_file = file;
  session.fail("Parse halted by #error directive: " + cut(text, 160, 124), "error-directive");
}

}  // namespace lute
