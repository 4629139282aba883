#include "compare/content_hash.hpp"

#include <OpenImageIO/hash.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

namespace lute::compare {
namespace fs = std::filesystem;

void ContentHash::add(std::string_view item) {
  text_ += std::to_string(item.size());
  text_ += ':';
  text_ += item;
}

std::string ContentHash::hex() const {
  std::array<char, 33> digits{};
  const unsigned long long high = OIIO::xxhash::XXH64(text_.data(), text_.size(), 1);
  const unsigned long long low = OIIO::xxhash::XXH64(text_.data(), text_.size(), 2);
  std::snprintf(digits.data(), digits.size(), "%016llx%016llx", high, low);
  return digits.data();
}

std::uint64_t number_of(std::string_view text) { return OIIO::xxhash::XXH64(text.data(), text.size(), 0); }

std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

namespace {

void add_quoted_names(std::set<fs::path>& files, const fs::path& folder, std::string_view text) {
  constexpr std::size_t kLongestName = 200;
  std::size_t open = text.find('"');
  while (open != std::string_view::npos) {
    const std::size_t close = text.find('"', open + 1);
    if (close == std::string_view::npos) return;
    const std::string_view name = text.substr(open + 1, close - open - 1);
    const bool one_line = name.find('\n') == std::string_view::npos;
    std::error_code ignored;
    if (!name.empty() && one_line && name.size() < kLongestName && fs::is_regular_file(folder / name, ignored)) {
      files.insert(folder / name);
    }
    // A stray quote (in a comment, say) must not turn all later strings inside out: go on within the line.
    open = one_line ? text.find('"', close + 1) : text.find('"', text.find('\n', open));
  }
}

}  // namespace

std::vector<fs::path> files_of_scene(const fs::path& scene, std::string_view text) {
  const fs::path folder = fs::absolute(scene).parent_path();
  std::set<fs::path> files;
  const bool all_scenes = scene.extension() == ".ini";  // names its scene, which may name others
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::error_code ignored;
    if (entry.is_regular_file(ignored) && (all_scenes || entry.path().extension() != ".pov")) files.insert(entry.path());
  }
  add_quoted_names(files, folder, text);
  return {files.begin(), files.end()};
}

std::string scene_hash(const fs::path& scene, const std::vector<std::string>& switches, std::string_view version) {
  const std::string text = read_file(scene);
  const fs::path folder = fs::absolute(scene).parent_path();
  ContentHash hash;
  hash.add(version);
  for (const std::string& item : switches) hash.add(item);
  hash.add(scene.filename().string());
  hash.add(text);
  for (const fs::path& file : files_of_scene(scene, text)) {
    hash.add(file.lexically_relative(folder).string());
    hash.add(read_file(file));
  }
  return hash.hex();
}

}  // namespace lute::compare
