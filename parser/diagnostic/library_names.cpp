#include "parser/diagnostic/library_names.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "parser/diagnostic/blank.hpp"
#include "parser/diagnostic/diagnostic.hpp"

namespace lute {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kLargestFile = 1u << 20;  // those of the library are up to 200 kB

std::vector<fs::path> include_files(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().extension() == ".inc") files.push_back(entry->path());
  }
  std::ranges::sort(files);
  return files;
}

bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The names behind each `keyword` and blanks, in the order of the text.
template <class F>
void for_each_name_behind(std::string_view text, std::string_view keyword, F&& f) {
  for (std::size_t at = text.find(keyword); at != std::string_view::npos; at = text.find(keyword, at)) {
    at += keyword.size();
    std::size_t begin = at;
    while (begin < text.size() && is_blank(text[begin])) ++begin;
    std::size_t end = begin;
    while (end < text.size() && in_name(text[end])) ++end;
    if (begin > at && end > begin) f(text.substr(begin, end - begin));
  }
}

std::string text_of(const fs::path& file) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error || size > kLargestFile) return "";
  std::ifstream stream(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

}  // namespace

LibraryNames::LibraryNames(std::span<const std::string> folders) {
  for (const std::string& folder : folders) {
    for (const fs::path& file : include_files(folder)) {
      const std::string text = text_of(file);
      const std::string file_name = file.filename().string();
      const auto add = [&](std::string_view name) {
        std::vector<std::string>& files = files_[std::string(name)];
        if (files.empty() || files.back() != file_name) files.push_back(file_name);
      };
      for_each_name_behind(text, "#declare", add);
      for_each_name_behind(text, "#macro", add);
    }
  }
}

std::span<const std::string> LibraryNames::files_of(std::string_view name) const {
  const auto found = files_.find(std::string(name));
  return found == files_.end() ? std::span<const std::string>() : std::span<const std::string>(found->second);
}

std::string nearest_include(std::span<const std::string> folders, std::string_view name) {
  std::vector<std::string> names;
  for (const std::string& folder : folders) {
    for (const fs::path& file : include_files(folder)) names.push_back(file.filename().string());
  }
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  return std::string(nearest_name(name, candidates));
}

}  // namespace lute
