// #include and #version; files are read and lexed once. Source: specification chapter 10 §6.1, §6.2.
#include <cmath>
#include <filesystem>
#include <utility>

#include "parser/diagnostic/library_names.hpp"
#include "parser/directives/directive.hpp"
#include "parser/expression/expression.hpp"

namespace lute {

namespace fs = std::filesystem;

namespace {

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

}  // namespace

void Session::prepare_writing(const std::string& path) {
  const std::string file = true_path(path).string();
  written.insert(file);
  for (const auto& known : files) {
    if (known->storage.follows_file() && true_path(known->name) == file) known->keep_text();
  }
}

SourceFile& Session::add_file(std::string name, FileText text, bool main_file) {
  auto file = std::make_unique<SourceFile>();
  file->name = std::move(name);
  file->set_text(std::move(text));
  file->index = static_cast<std::uint32_t>(files.size());
  begin_lexing(*file, names, main_file);
  if (file->byte_order_mark) language.charset = Reader::Charset::kUtf8;
  scene.files.push_back(file->name);
  files.push_back(std::move(file));
  return *files.back();
}

SourceFile* Session::load(const std::string& path) {
  const auto known = by_path.find(path);
  SourceFile* const before = known != by_path.end() && !known->second->forgotten ? known->second : nullptr;
  if (before != nullptr && (written.empty() || !written.contains(true_path(path)))) return before;
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error || !is_file(path)) return nullptr;
  if (size > options.limits.file_bytes) {
    fail("File '" + path + "' is larger than the limit of " + std::to_string(options.limits.file_bytes) + " bytes.",
         "limit-file");
  }
  resources.charge(size);
  std::optional<FileText> text = FileText::of_file(path, size);
  if (!text) return nullptr;
  if (before != nullptr && before->text == text->view()) return before;
  SourceFile& file = add_file(path, std::move(*text), files.empty());
  by_path.insert_or_assign(path, &file);
  return &file;
}

void include_file(Session& session, const std::string& name) {
  const auto path = find_scene_file(session, name, {".inc", ".INC"});
  SourceFile* const file = path ? session.load(*path) : nullptr;
  if (file == nullptr) {
    session.possible_error("Cannot find file '" + name + "', even after trying to append file type extension.", "missing-file");
    Diagnostic d = session.diagnose(Severity::kError, "missing-include", "Cannot open include file " + name + ".", session.stream.last_file,
                                    session.stream.last_token);
    const std::string nearest = nearest_include(session.options.library_paths, name);
    if (!nearest.empty()) d.hint = "did you mean '" + nearest + "'?";
    session.report_fatal(std::move(d));
  }
  session.stream.enter_file(*file);
}

void run_include(Session& session) {
  std::u16string name;
  try {
    name = parse_string(session, true);
  } catch (const SceneError&) {
    session.recovery.miss_include();
    throw;
  }
  // A token behind the name that was read while the string ended belongs to this file, not to the included one.
  session.stream.unread();
  // A name without its end quote is the rest of the file.
  const Token* const next = session.stream.frames.back().cursor;
  const bool is_open = next->kind == TokenKind::kError && session.stream.last_token != nullptr &&
                       session.stream.last_token->kind == TokenKind::kString && next->offset == session.stream.last_token->offset;
  if (is_open) session.stream.peek();  // throws
  include_file(session, to_bytes(session, name));
}

void run_version(Session& session) {
  TokenStream& stream = session.stream;
  if (stream.peek_raw().is(TokenKind::kName) && session.names.text(stream.peek_raw().token.index) == "unofficial") {
    stream.take_raw();
  }
  const bool first = stream.frames.size() == 1 && stream.last_token == stream.frames.back().file->tokens.data() + 1;
  double version = 0;
  {
    const TokenStream::AfterOperand no_directives(stream, false);
    version = session.reader.number();
    stream.fetch_after_operand();
    if (stream.at_written(TokenKind::kSemicolon)) {
      stream.take();
    } else {
      session.possible_error("Semi-colon ';' expected at end of #version.", "missing-semicolon");
    }
  }
  const double hundredths = std::trunc(100 * version + 0.5);  // as in the reference: -1 is -0.99
  if (!(hundredths <= 370)) {
    char text[80];
    std::snprintf(text, sizeof text, "Your scene file requires POV-Ray version %.1f or later!", version > 3.8 ? version : 3.8);
    session.fail(text, "version");
  }
  const int before = std::exchange(session.language.version, static_cast<int>(std::max(-1e9, hundredths)));
  if ((before < kFirstVersionWithOperators) != (session.language.version < kFirstVersionWithOperators)) forget_compiled(session);
  if (!session.language.version_given && !first) session.language.version_first = false;
  session.language.version_given = true;
  if (!session.noise_generator_given) session.scene.settings.noise_generator = session.language.version < 350 ? 1 : 2;
}

}  // namespace lute
