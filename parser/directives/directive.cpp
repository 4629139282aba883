#include "parser/directives/directive.hpp"

#include "parser/directives/directive_words.hpp"

namespace lute {

namespace {

// Directives inside the arguments of directives, without end, must not exhaust the stack.
constexpr int kMostNestedDirectives = 200;

void dispatch(Session& session, Word word) {
  switch (word) {
    case Word::kDeclare: return run_declare(session, false);
    case Word::kLocal: return run_declare(session, true);
    case Word::kUndef: return run_undef(session);
    case Word::kIf: return run_if(session);
    case Word::kIfdef: return run_ifdef(session, true);
    case Word::kIfndef: return run_ifdef(session, false);
    case Word::kElseif: return run_elseif(session);
    case Word::kElse: return run_else(session);
    case Word::kEnd: return run_end(session);
    case Word::kWhile: return run_while(session);
    case Word::kFor: return run_for(session);
    case Word::kSwitch: return run_switch(session);
    case Word::kCase:
    case Word::kRange: return run_case(session, word);
    case Word::kBreak: return run_break(session);
    case Word::kMacro: return run_macro(session);
    case Word::kInclude: return run_include(session);
    case Word::kVersion: return run_version(session);
    case Word::kDefault: return parse_default(session.reader);
    case Word::kDebug:
    case Word::kWarning:
    case Word::kRender:
    case Word::kStatistics: return run_text_stream(session, word);
    case Word::kError: return run_error(session);
    case Word::kFopen: return run_fopen(session);
    case Word::kFclose: return run_fclose(session);
    case Word::kRead: return run_read(session);
    case Word::kWrite: return run_write(session);
    default: return;
  }
}

// A `#` without a directive means nothing, unless a number comes next. What is behind the `#` is reported, not the `#`.
void pass_over_hash(Session& session) {
  ++session.stream.frames.back().cursor;
  ++session.stream.events;
  const Item next = session.stream.peek_raw();
  if (printed_name(session, next).starts_with("float function")) session.fail_expected("object or directive.", next);
}

}  // namespace

void run_directive(Session& session) {
  TokenStream& stream = session.stream;
  TokenFrame& frame = stream.frames.back();
  const Token* const hash = frame.cursor;
  const Token* const keyword = hash + 1;
  if (keyword == frame.end || !is_directive(*keyword)) {
    pass_over_hash(session);
    return;
  }
  frame.cursor = keyword + 1;
  stream.last_file = frame.file->index;
  stream.last_token = keyword;
  ++stream.events;
  const Word word = keyword->word;  // before frames move

  const TokenStream::Aside aside(stream, true);
  const ExpressionState::Interruption interruption(session.expressions);
  if (++session.nested_directives > kMostNestedDirectives) session.fail("Directives are nested too deeply.", "nesting");
  dispatch(session, word);
  --session.nested_directives;
  stream.unread();
}

}  // namespace lute
