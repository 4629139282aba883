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

// Every .pov file of the arguments (a folder counts with all its sub-folders), sorted by name; `filter` is an
// ECMAScript regular expression searched in the name, empty = all. Throws std::runtime_error for an argument that does
// not exist.
std::vector<SceneFile> find_scenes(const std::vector<std::string>& arguments, const std::string& filter = "");

}  // namespace lute::compare
