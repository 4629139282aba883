// Which file of the include library declares a name that a scene uses without including it. For messages: the files are searched as
// text, and those that cannot be read are passed over.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

namespace lute {

class LibraryNames {
 public:
  // All names behind `#declare` and `#macro` in the .inc files of the folders. Of two files with a name the first counts, by the order
  // of the folders, then by that of the file names.
  explicit LibraryNames(std::span<const std::string> folders);

  // The name of the file, or "".
  std::string file_of(std::string_view name) const;

 private:
  std::unordered_map<std::string, std::string> files_;
};

// The .inc file of the folders whose name is nearest to `name`, near enough to be a slip; else "".
std::string nearest_include(std::span<const std::string> folders, std::string_view name);

}  // namespace lute
