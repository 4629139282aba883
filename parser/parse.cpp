#include "parser/parse.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <new>

#include "engine/function/program.hpp"
#include "parser/diagnostic/advice.hpp"
#include "parser/directives/directive.hpp"
#include "parser/expression/expression.hpp"

namespace lute {

namespace {

void predeclare(Session& session, std::string_view name, Value value) {
  const NameId id = session.names.intern(name);
  if (SymbolTable::Entry* entry = session.symbols.find(id)) {
    *entry->slot = std::move(value);
  } else if (!Names::is_word(id)) {
    session.symbols.add(id, 0, std::make_shared<Value>(std::move(value)));
  }
}

// Predeclared numbers pass through a text of six significant digits.
Value rounded(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%g", value);
  return Number(std::strtod(text, nullptr));
}

Value string_value(std::string_view text) { return std::make_shared<const std::u16string>(from_bytes(text)); }

void predeclare_all(Session& session) {
  const ParseOptions& options = session.options;
  predeclare(session, "image_width", rounded(options.width));
  predeclare(session, "image_height", rounded(options.height));
  predeclare(session, "input_file_name", string_value(std::filesystem::path(options.input_file).filename().string()));
  predeclare(session, "frame_number", rounded(options.frame.frame_number));
  predeclare(session, "initial_frame", rounded(options.frame.initial_frame));
  predeclare(session, "final_frame", rounded(options.frame.final_frame));
  predeclare(session, "initial_clock", rounded(options.frame.initial_clock));
  predeclare(session, "final_clock", rounded(options.frame.final_clock));
  predeclare(session, "clock_delta", rounded(options.frame.clock_delta));
  for (const auto& [name, value] : options.declares) {
    if (value.size() >= 2 && value.front() == '"' && value.back() == '"') {
      predeclare(session, name, string_value(std::string_view(value).substr(1, value.size() - 2)));
    } else {
      predeclare(session, name, rounded(std::strtod(value.c_str(), nullptr)));
    }
  }
}

void open_scene(Session& session) {
  const ParseOptions& options = session.options;
  SourceFile* main_file = nullptr;
  if (options.input_text) {
    main_file = &session.add_file(options.input_file, FileText(*options.input_text), true);
  } else {
    const auto path = find_scene_file(session, options.input_file, {".pov", ".POV"});
    if (path) main_file = session.load(*path);
    if (main_file == nullptr) session.fail("Cannot open input file '" + options.input_file + "'.", "missing-file");
  }
  session.stream.enter_file(*main_file);
  if (!options.include_header.empty()) {
    session.permissions.allow_read(std::filesystem::path(options.include_header).parent_path().string());
    include_file(session, options.include_header);
  }
}

// The old spellings of directives without '#', at the top level only.
bool parse_old_directive(Session& session) {
  TokenStream& stream = session.stream;
  const Word word = stream.peek().word();
  switch (word) {
    case Word::kDeclare:
    case Word::kInclude:
      stream.take();
      session.warn("Should have '#' before '" + std::string(spelling(word)) + "'.", "missing-hash");
      if (session.language.version >= 350) {
        session.possible_error("Should have '#' before '" + std::string(spelling(word)) + "'.", "missing-hash");
      }
      break;
    case Word::kVersion:
    case Word::kDefault: stream.take(); break;
    default: return false;
  }
  if (word == Word::kDeclare) run_declare(session, false);
  if (word == Word::kInclude) run_include(session);
  if (word == Word::kVersion) run_version(session);
  if (word == Word::kDefault) parse_default(session.reader);
  stream.return_hash();
  return true;
}

void parse_statements(Session& session) {
  while (!session.stream.peek_statement().is(TokenKind::kEnd)) {
    if (!session.recovery.within_budget()) return;
    if (parse_old_directive(session)) continue;
    session.open_blocks.clear();
    if (!parse_statement(session.reader)) session.fail_expected("object or directive", session.reader.peek());
  }
}

// What the engine finds out while it answers a question of the scene is an error where the question was asked.
void parse_statements_and_ask(Session& session) {
  try {
    parse_statements(session);
  } catch (const EndlessFunction& error) {
    session.fail(error.what(), "endless-function");
  }
}

// To the end of the scene, past the errors in it.
void parse_all_statements(Session& session) {
  for (;;) {
    try {
      return parse_statements_and_ask(session);
    } catch (const SceneError& error) {
      if (!session.recovery.recover(error)) return;
    }
  }
}

void finish(Session& session) {
  session.stream.last_token = nullptr;  // what follows belongs to the scene, not to a place in it
  session.scene.version = std::max(session.language.version, 350);
  session.scene.effective_version = session.reader.effective_version();
  if (!session.noise_generator_given) session.scene.settings.noise_generator = session.language.version < 350 ? 1 : 2;
  if (session.spline_used) {
    session.warn("This scene uses an experimental feature: spline.", "experimental");
  }
  if (!session.language.version_given) {
    session.warn("This scene did not contain a #version directive. It is read as if written for version 3.62.", "version");
  } else if (!session.language.version_first) {
    session.warn("The #version directive should be the first of the scene.", "version");
  }
  finish_scene(session.reader);
}

// What reading has allocated itself is free again by now: there is room for a message.
void report_out_of_memory(Session& session) {
  Diagnostic d = session.diagnose(Severity::kError, "limit-memory", "The scene needs more memory than there is.", session.stream.last_file,
                                  session.stream.last_token);
  d.hint = advice(d);
  session.diagnostics.report(d);
}

}  // namespace

ParseResult parse_scene(const ParseOptions& options) {
  ParseResult result;
  Session session(options);
  if (options.version) {
    session.language.version = *options.version;
    session.language.version_given = true;
  }
  try {
    predeclare_all(session);
    open_scene(session);
    parse_all_statements(session);
    result.ok = !session.recovery.any();
    if (result.ok) finish(session);
  } catch (const SceneError& error) {
    session.diagnostics.report(error.diagnostic());
  } catch (const std::bad_alloc&) {
    report_out_of_memory(session);
  }
  result.scene = std::move(session.scene);
  result.diagnostics = session.diagnostics.all();
  return result;
}

std::string dump_tokens(const std::string& file_name, std::string_view text) {
  Names names;
  SourceFile file;
  file.name = file_name;
  file.set_text(FileText(std::string(text)));
  lex(file, names, true);
  std::string out;
  for (const Token& token : file.tokens) {
    const SourceLocation where = file.locate(token.offset);
    out += std::to_string(where.line) + ":" + std::to_string(where.column) + " ";
    char number[40];
    switch (token.kind) {
      case TokenKind::kNumber:
        std::snprintf(number, sizeof number, "number %.17g", token.number);
        out += number;
        break;
      case TokenKind::kString: out += "string \"" + file.strings[token.index] + "\""; break;
      case TokenKind::kName: out += "name " + std::string(names.text(token.index)); break;
      case TokenKind::kWord: out += "word " + std::string(spelling(token.word)); break;
      case TokenKind::kError: out += "error " + file.errors[token.index]; break;
      case TokenKind::kOther: out += "other " + std::string(1, static_cast<char>(token.index)); break;
      case TokenKind::kEnd: out += "end"; break;
      default: out += name_of(token.kind); break;
    }
    out += '\n';
  }
  return out;
}

}  // namespace lute
