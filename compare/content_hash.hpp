// A 128-bit name for everything that decides the picture of a scene: its text, the files that it may read beside it,
// the switches and the version of the program.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lute::compare {

class ContentHash {
 public:
  // Each item is separated from the next, so that moving a byte between items changes the hash.
  void add(std::string_view item);
  std::string hex() const;  // 32 digits

 private:
  std::string text_;
};

// The same number for the same text on every machine.
std::uint64_t number_of(std::string_view text);

// The whole file; throws std::runtime_error when it cannot be read.
std::string read_file(const std::filesystem::path& path);

// The files that a scene may read beside it: every file of its folder except other scenes
// (with them for an INI file, which names its scene),
// and whatever its text names in quotes relative to the folder (other scenes included).
std::vector<std::filesystem::path> files_of_scene(const std::filesystem::path& scene, std::string_view text);

std::string scene_hash(const std::filesystem::path& scene, const std::vector<std::string>& switches,
                       std::string_view version);

}  // namespace lute::compare
