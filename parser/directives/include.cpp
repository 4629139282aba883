// #include and #version; the search for files. Source: specification chapter 10 §6.1, §6.2.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "parser/directives/directive.hpp"
#include "parser/expression/expression.hpp"

namespace lute {

namespace fs = std::filesystem;

namespace {

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

bool ends_with(const std::string& name, std::string_view extension) {
  return name.size() >= extension.size() && std::string_view(name).substr(name.size() - extension.size()) == extension;
}

std::string lower(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return text;
}

// The file of `folder` / `name` when upper and lower case are not told apart in any part of the name.
std::optional<fs::path> find_ignoring_case(const fs::path& folder, const fs::path& name) {
  fs::path at = folder.empty() ? fs::path(".") : folder;
  for (const fs::path& part : name) {
    if (part == "." || part == ".." || part == "/") {
      at = part == "/" ? part : at / part;
      continue;
    }
    std::error_code error;
    std::vector<fs::path> matches;
    for (fs::directory_iterator entry(at, error), end; !error && entry != end; entry.increment(error)) {
      if (lower(entry->path().filename().string()) == lower(part.string())) matches.push_back(entry->path());
    }
    if (matches.empty()) return std::nullopt;
    at = *std::min_element(matches.begin(), matches.end());
  }
  if (!is_file(at)) return std::nullopt;
  return at;
}

// Names in the order in which they are tried.
std::vector<std::string> variants(const std::string& name, std::initializer_list<std::string_view> extensions) {
  std::vector<std::string> result;
  const bool has_extension =
      std::any_of(extensions.begin(), extensions.end(), [&](std::string_view e) { return ends_with(name, e); });
  if (has_extension) result.push_back(name);
  for (const std::string_view extension : extensions) result.push_back(name + std::string(extension));
  if (!has_extension) result.push_back(name);
  return result;
}

}  // namespace

std::optional<std::string> find_scene_file(Session& session, const std::string& name,
                                           std::initializer_list<std::string_view> extensions) {
  if (name.empty()) return std::nullopt;
  const std::vector<std::string> names = variants(name, extensions);
  const bool absolute = fs::path(name).is_absolute();
  std::vector<fs::path> folders{fs::path()};
  if (!absolute) folders.insert(folders.end(), session.options.library_paths.begin(), session.options.library_paths.end());
  for (const std::string& variant : names) {
    for (const fs::path& folder : folders) {
      if (is_file(folder / variant)) return (folder / variant).string();
    }
  }
  // Not in the reference: beside the scene, then without regard to case.
  const fs::path scene_folder = fs::path(session.options.input_file).parent_path();
  if (!absolute && !scene_folder.empty()) {
    folders.push_back(scene_folder);
    for (const std::string& variant : names) {
      if (is_file(scene_folder / variant)) return (scene_folder / variant).string();
    }
  }
  for (const std::string& variant : names) {
    for (const fs::path& folder : folders) {
      if (const auto found = find_ignoring_case(folder, variant)) {
        session.warn("File '" + name + "' was found as '" + found->string() + "' only because upper and lower case were ignored.",
                     "file-case");
        return found->string();
      }
    }
  }
  return std::nullopt;
}

SourceFile& Session::add_file(std::string name, std::string text, bool main_file) {
  auto file = std::make_unique<SourceFile>();
  file->name = std::move(name);
  file->text = std::move(text);
  file->index = static_cast<std::uint32_t>(files.size());
  lex(*file, names, main_file);
  if (file->byte_order_mark) language.charset = Reader::Charset::kUtf8;
  scene.files.push_back(file->name);
  files.push_back(std::move(file));
  return *files.back();
}

SourceFile* Session::load(const std::string& path) {
  if (const auto known = by_path.find(path); known != by_path.end()) return known->second;
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error || !is_file(path)) return nullptr;
  if (size > options.limits.file_bytes) fail("File '" + path + "' is too large.", "limit-file");
  std::ifstream in(path, std::ios::binary);
  if (!in) return nullptr;
  std::string text(size, '\0');
  in.read(text.data(), static_cast<std::streamsize>(size));
  text.resize(static_cast<std::size_t>(in.gcount()));
  SourceFile& file = add_file(path, std::move(text), files.empty());
  by_path.emplace(path, &file);
  return &file;
}

void include_file(Session& session, const std::string& name) {
  const auto path = find_scene_file(session, name, {".inc", ".INC"});
  SourceFile* const file = path ? session.load(*path) : nullptr;
  if (file == nullptr) {
    session.possible_error("Cannot find file '" + name + "', even after trying to append file type extension.", "missing-file");
    session.fail("Cannot open include file " + name + ".", "missing-file");
  }
  session.stream.enter_file(*file);
}

void run_include(Session& session) {
  const std::u16string name = parse_string(session, true);
  // A token behind the name that was read while the string ended belongs to this file, not to the included one.
  session.stream.unread();
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
  const double hundredths = std::floor(100 * version + 0.5);
  if (!(hundredths <= 370)) {
    char text[80];
    std::snprintf(text, sizeof text, "Your scene file requires POV-Ray version %.1f or later!", version > 3.8 ? version : 3.8);
    session.fail(text, "version");
  }
  session.language.version = static_cast<int>(std::max(0.0, hundredths));
  if (!session.language.version_given && !first) session.language.version_first = false;
  session.language.version_given = true;
  if (!session.noise_generator_given) session.scene.settings.noise_generator = session.language.version < 350 ? 1 : 2;
}

}  // namespace lute
