#include "compare/scene_files.hpp"

#include <algorithm>
#include <regex>
#include <stdexcept>

#include "compare/content_hash.hpp"
#include "compare/frame_strip.hpp"

namespace lute::compare {
namespace fs = std::filesystem;

namespace {

bool is_scene(const fs::path& file) { return file.extension() == ".pov" || (is_frame_set(file) && scene_of_set(file)); }

}  // namespace

std::vector<SceneFile> find_scenes(const std::vector<std::string>& arguments, const std::string& filter) {
  std::vector<SceneFile> scenes;
  for (const std::string& argument : arguments) {
    if (!fs::exists(argument)) throw std::runtime_error("no such scene or folder: " + argument);
    if (!fs::is_directory(argument)) {
      scenes.push_back({argument, fs::path(argument).filename().string()});
      continue;
    }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(argument)) {
      if (!entry.is_regular_file() || !is_scene(entry.path())) continue;
      scenes.push_back({entry.path(), entry.path().lexically_relative(argument).string()});
    }
  }
  if (!filter.empty()) {
    const std::regex wanted(filter);
    std::erase_if(scenes, [&](const SceneFile& scene) { return !std::regex_search(scene.name, wanted); });
  }
  std::sort(scenes.begin(), scenes.end(), [](const SceneFile& a, const SceneFile& b) { return a.name < b.name; });
  return scenes;
}

std::vector<SceneFile> sample_scenes(std::vector<SceneFile> scenes, int one_of) {
  const auto modulus = static_cast<std::uint64_t>(one_of);
  std::erase_if(scenes, [&](const SceneFile& scene) { return number_of(scene.name) % modulus != 0; });
  return scenes;
}

}  // namespace lute::compare
