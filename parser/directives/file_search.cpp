// The search for files. Source: specification chapter 10 §6.1.
#include <algorithm>
#include <filesystem>

#include "parser/session.hpp"

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

std::optional<std::string> search(Session& session, const std::string& name, std::initializer_list<std::string_view> extensions) {
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

}  // namespace

std::optional<std::string> find_scene_file(Session& session, const std::string& name,
                                           std::initializer_list<std::string_view> extensions) {
  const std::optional<std::string> found = search(session, name, extensions);
  if (found && !session.permissions.may_read(*found)) {
    Diagnostic d = session.diagnose(Severity::kError, "io-restriction", "IO restrictions prohibit read access to '" + *found + "'.",
                                    session.stream.last_file, session.stream.last_token);
    d.hint = "--allow-read FOLDER permits it";
    session.report_fatal(std::move(d));
  }
  return found;
}

}  // namespace lute
