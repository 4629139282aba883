// Everything that one parse keeps. The parts of the language core (directives, expressions, reader) work on it; statements
// see only the Reader.
#pragma once

#include <deque>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "parser/diagnostic/library_names.hpp"
#include "parser/directives/token_stream.hpp"
#include "parser/expression/code.hpp"
#include "parser/file_permissions.hpp"
#include "parser/lexer/source_file.hpp"
#include "parser/parse.hpp"
#include "parser/reader.hpp"
#include "parser/recovery/recovery.hpp"
#include "parser/resource_meter.hpp"
#include "parser/statement/statement.hpp"
#include "parser/value/symbol_table.hpp"

namespace lute {

struct LanguageState {
  int version = 370;           // times 100
  bool version_given = false;  // by #version or the Version option
  bool version_first = true;   // no #version came after other text
  bool assumed_gamma_given = false;
  Reader::Charset charset = Reader::Charset::kAscii;
};

// A block that is being read: the place of its keyword.
struct OpenBlock {
  std::uint32_t file = 0;
  const Token* keyword = nullptr;
};

struct Session {
  explicit Session(const ParseOptions& parse_options);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const ParseOptions& options;
  FilePermissions permissions;
  DiagnosticSink diagnostics;
  Scene scene;
  LanguageState language;

  Names names;
  std::deque<std::unique_ptr<SourceFile>> files;         // by SourceLocation::file
  std::unordered_map<std::string, SourceFile*> by_path;  // a file is read and lexed once ...
  std::set<std::string> written;                         // ... except those, by their true path, that the scene writes
  SymbolTable symbols;
  Reader reader;
  TokenStream stream;
  Recovery recovery;
  ExpressionState expressions;
  std::vector<std::uint32_t> random_states;  // of the streams that seed() made
  std::string debug_line;                    // #debug text that has no line end yet
  ResourceMeter resources;
  int nested_directives = 0;
  std::vector<OpenBlock> open_blocks;
  std::optional<NameId> being_declared;  // by the #declare or #local whose value is being read
  bool spline_used = false;  // an experimental feature: told at the end
  bool noise_generator_given = false;  // by global_settings: #version no longer changes it

  std::optional<LibraryNames> library_names;  // read when the first message needs them

  DeclareValues declare_values;
  std::unique_ptr<StatementState> statements;

  // Adds a file's text to the table and lexes it.
  SourceFile& add_file(std::string name, FileText text, bool main_file);
  // The file at `path`, read on first use, and again when the scene has changed it; null if it cannot be opened.
  SourceFile* load(const std::string& path);
  // The file at `path` is about to be written: it will be read again.
  void prepare_writing(const std::string& path);

  SourceLocation locate(std::uint32_t file, const Token* token) const;

  // Messages at a token; the chain of includes and macro calls is added.
  Diagnostic diagnose(Severity severity, std::string code, std::string message, std::uint32_t file, const Token* token);
  [[noreturn]] void fail(std::string message, std::string code = "scene-error", std::string hint = "");  // at the token taken last
  [[noreturn]] void fail_at(std::string message, std::string code, const Item& item);
  // At the end of a file; names what was opened last: the #macro whose keyword this is, or the innermost conditional.
  [[noreturn]] void fail_missing_end(const Item& item, const Token* macro_keyword = nullptr);
  [[noreturn]] void fail_after(std::string message, std::string code, std::string hint);  // behind the token taken last
  [[noreturn]] void fail_expected(std::string_view what, const Item& found);
  [[noreturn]] void report_fatal(Diagnostic diagnostic);  // with advice
  void warn(std::string message, std::string code = "warning");
  void possible_error(std::string message, std::string code = "possible-error");
};

// As messages print what was found: "{", "undeclared identifier 'foo'", "float function 'float constant'", ...
std::string printed_name(const Session& session, const Item& item);

// The search of chapter 10 §6.1. A name found only beside the scene, or only when case is ignored, is found too, the latter
// with a warning.
std::optional<std::string> find_scene_file(Session& session, const std::string& name,
                                           std::initializer_list<std::string_view> extensions);

}  // namespace lute
