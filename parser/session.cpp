#include "parser/session.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "parser/diagnostic/advice.hpp"
#include "parser/diagnostic/block_advice.hpp"
#include "parser/diagnostic/context_advice.hpp"
#include "parser/diagnostic/suggestion.hpp"
#include "parser/directives/directive_words.hpp"
#include "parser/expression/expression.hpp"
#include "parser/statement/statement.hpp"

namespace lute {

Session::Session(const ParseOptions& parse_options)
    : options(parse_options),
      diagnostics(parse_options.on_diagnostic),
      reader(*this),
      stream(*this),
      recovery(*this),
      resources(*this, parse_options.limits),
      declare_values(make_declare_values()),
      statements(make_statement_state()) {
  const std::string scene_folder = std::filesystem::path(options.input_file).parent_path().string();
  for (const std::string& folder : {std::string(), scene_folder}) {
    permissions.allow_read(folder);
    permissions.allow_write(folder);
  }
  for (const std::string& folder : options.library_paths) permissions.allow_read(folder);
  for (const std::string& folder : options.allow_read) permissions.allow_read(folder);
  for (const std::string& folder : options.allow_write) permissions.allow_write(folder);
}

Session::~Session() = default;

SourceLocation Session::locate(std::uint32_t file, const Token* token) const {
  if (token == nullptr || file >= files.size()) return {};
  return files[file]->locate(token->offset);
}

namespace {

// Behind the last token of a file.
std::uint32_t end_of_tokens(const SourceFile& file) {
  if (file.tokens.size() < 2) return 0;
  const Token& last = file.tokens[file.tokens.size() - 2];
  return last.kind == TokenKind::kRun ? file.runs[last.index].end : token_end(file, last);
}

// A line may be as long as its file (one that is no text): what lies far behind the place is left out.
std::string_view excerpt(const SourceFile& file, SourceLocation where) {
  constexpr std::size_t kBehind = 1024;  // a message shows less than that
  return file.line(where.line, where.column + kBehind);
}

}  // namespace

Diagnostic Session::diagnose(Severity severity, std::string code, std::string message, std::uint32_t file, const Token* token) {
  if (severity == Severity::kError) recovery.set_place(file, token);
  Diagnostic d;
  d.severity = severity;
  d.code = std::move(code);
  for (char& c : message) c = c == '\n' ? ' ' : c;
  d.message = std::move(message);
  if (token == nullptr || file >= files.size()) {
    d.file = options.input_file;
    return d;
  }
  const SourceFile& source = *files[file];
  d.file = source.name;
  if (token->kind == TokenKind::kEnd) {  // empty lines and comments at the end say nothing: behind the last token
    d.where = source.locate(end_of_tokens(source));
    d.end_column = d.where.column;
  } else {
    d.where = source.locate(token->offset);
    d.end_column = d.where.column + token_end(source, *token) - token->offset;
  }
  d.excerpt = excerpt(source, d.where);
  // The way to the place: from the innermost frame out.
  constexpr std::size_t kMostNotes = 20;
  for (std::size_t i = stream.frames.size(); i-- > 1 && d.chain.size() < kMostNotes;) {
    const TokenFrame& frame = stream.frames[i];
    const TokenFrame& caller = stream.frames[i - 1];
    // The caller's cursor is behind the call's closing parenthesis, or behind the name of the include file.
    const Token* call = caller.cursor == caller.file->tokens.data() ? caller.cursor : caller.cursor - 1;
    if (frame.macro) {
      while (call > caller.file->tokens.data() && !(call->kind == TokenKind::kName && call->index == frame.macro->name)) --call;
    }
    DiagnosticNote note;
    note.text = frame.macro ? "in macro '" + std::string(names.text(frame.macro->name)) + "', called from" : "included from";
    note.file = caller.file->name;
    note.where = caller.file->locate(call->offset);
    d.chain.push_back(std::move(note));
  }
  return d;
}

void Session::report_fatal(Diagnostic diagnostic) {
  if (std::string hint = context_advice(diagnostic); !hint.empty()) diagnostic.hint = std::move(hint);
  if (diagnostic.hint.empty()) diagnostic.hint = form_of_block(*this, diagnostic);
  if (diagnostic.hint.empty()) diagnostic.hint = advice(diagnostic);
  throw SceneError(std::move(diagnostic));
}

void Session::fail(std::string message, std::string code, std::string hint) {
  Diagnostic d = diagnose(Severity::kError, std::move(code), std::move(message), stream.last_file, stream.last_token);
  d.hint = std::move(hint);
  report_fatal(std::move(d));
}

void Session::fail_at(std::string message, std::string code, const Item& item) {
  Diagnostic d = diagnose(Severity::kError, std::move(code), std::move(message), item.file, item.source);
  d.hint = suggestion(*this, item);
  report_fatal(std::move(d));
}

void Session::fail_missing_end(const Item& item, const Token* macro_keyword) {
  Diagnostic d = diagnose(Severity::kError, "missing-end", "End of file reached but #end expected.", item.file, item.source);
  if (macro_keyword != nullptr) {
    const SourceFile& file = *files[item.file];
    d.chain.insert(d.chain.begin(), {"'#macro' was opened at", file.name, file.locate(macro_keyword[-1].offset)});
    report_fatal(std::move(d));
  }
  const Conditional* const open = stream.conditionals.empty() ? nullptr : &stream.conditionals.back();
  if (open != nullptr && open->start != nullptr && open->frame < stream.frames.size()) {
    const SourceFile& file = *stream.frames[open->frame].file;
    const Token* const first = file.tokens.data();
    const Token* word = open->start;  // behind the directive's keyword
    if (word >= first && word < first + file.tokens.size()) {
      while (word > first && !(word[-1].kind == TokenKind::kHash && opens_region(*word))) --word;
      if (word > first) {
        d.chain.insert(d.chain.begin(), {"'#" + std::string(spelling(word->word)) + "' was opened at", file.name,
                                         file.locate(word[-1].offset)});
      }
    }
  }
  report_fatal(std::move(d));
}

void Session::fail_after(std::string message, std::string code, std::string hint) {
  Diagnostic d = diagnose(Severity::kError, std::move(code), std::move(message), stream.last_file, stream.last_token);
  d.where.column = d.end_column;
  d.end_column = d.where.column + 1;
  d.hint = std::move(hint);
  report_fatal(std::move(d));
}

void Session::fail_expected(std::string_view what, const Item& found) {
  // #read alone may name such an element, to fill it.
  const bool element_without_value = found.is(TokenKind::kIdentifier) && found.slot->empty() && found.subscripts > 0;
  if (element_without_value && what != "undeclared identifier") {
    fail_at("Attempt to access uninitialized array element.", "uninitialized", found);
  }
  Diagnostic d = diagnose(Severity::kError, "expected-token",
                          "Expected '" + std::string(what) + "', " + printed_name(*this, found) + " found instead", found.file,
                          found.source);
  d.hint = about_parenthesis(*this, what, found);
  if (d.hint.empty()) d.hint = suggestion(*this, found, what);
  report_fatal(std::move(d));
}

void Session::warn(std::string message, std::string code) {
  Diagnostic d = diagnose(Severity::kWarning, std::move(code), std::move(message), stream.last_file, stream.last_token);
  d.hint = advice(d);
  diagnostics.report(std::move(d));
}

void Session::possible_error(std::string message, std::string code) {
  diagnostics.report(diagnose(Severity::kPossibleError, std::move(code), std::move(message), stream.last_file, stream.last_token));
}

namespace {

std::string word_name(Word word) {
  const std::string text(spelling(word));
  switch (word) {
    case Word::kX: case Word::kY: case Word::kZ: case Word::kVcross: case Word::kVnormalize: case Word::kVrotate:
    case Word::kVaxisRotate: case Word::kVturbulence: case Word::kTrace: case Word::kMinExtent: case Word::kMaxExtent:
      return "vector function '" + text + "'";
    case Word::kRgb: case Word::kRgbf: case Word::kRgbt: case Word::kRgbft: case Word::kSrgb: case Word::kSrgbf:
    case Word::kSrgbt: case Word::kSrgbft: case Word::kRed: case Word::kGreen: case Word::kBlue: case Word::kFilter:
    case Word::kTransmit: case Word::kAlpha: case Word::kGray: return "color keyword '" + text + "'";
    default: break;
  }
  Item item;
  item.token.kind = TokenKind::kWord;
  item.token.word = word;
  return starts_number(item) ? "float function '" + text + "'" : text;
}

}  // namespace

std::string printed_name(const Session& session, const Item& item) {
  switch (item.token.kind) {
    case TokenKind::kName: return "undeclared identifier '" + std::string(session.names.text(item.token.index)) + "'";
    case TokenKind::kWord: return word_name(item.token.word);
    case TokenKind::kNumber: return "float function 'float constant'";
    case TokenKind::kIdentifier: {
      if (item.slot->empty()) return "empty array";
      const std::string_view type = type_name(*item.slot);
      if (type == "float identifier") return "float function 'float identifier'";
      if (type == "vector identifier") return "vector function 'vector identifier'";
      return std::string(type);
    }
    case TokenKind::kOther: return std::string(1, static_cast<char>(item.token.index));
    default: return std::string(name_of(item.token.kind));
  }
}

}  // namespace lute
