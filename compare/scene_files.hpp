// The scenes that a command works on.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lute::compare {

struct SceneFile {
  std::filesystem::path path;
  std::string name;  // relative to the argument that brought it, so that tables are the same wherever the scenes lie
};

// Every scene file, and every INI file that names a scene, of the arguments (a folder counts with all its sub-folders), sorted by name; `filter` is an
// ECMAScript regular expression searched in the name, empty = all. Throws std::runtime_error for an argument that does
// not exist.
std::vector<SceneFile> find_scenes(const std::vector<std::string>& arguments, const std::string& filter = "");

// About one scene of `one_of`. A scene is in or out by its name alone, so that new scenes do not change who is.
std::vector<SceneFile> sample_scenes(std::vector<SceneFile> scenes, int one_of);

}  // namespace lute::compare
