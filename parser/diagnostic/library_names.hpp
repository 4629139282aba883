// Which file of the include library declares a name that a scene uses without including it. For messages: the files are searched as
// text, and those that cannot be read are passed over.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace lute {

class LibraryNames {
 public:
  // All names behind `#declare` and `#macro` in the .inc files of the folders.
  explicit LibraryNames(std::span<const std::string> folders);

  // The names of the files that declare it, in the order of the folders, then of the file names.
  std::span<const std::string> files_of(std::string_view name) const;

 private:
  std::unordered_map<std::string, std::vector<std::string>> files_;
};

// The .inc file of the folders whose name is nearest to `name`, near enough to be a slip; else "".
std::string nearest_include(std::span<const std::string> folders, std::string_view name);

}  // namespace lute
