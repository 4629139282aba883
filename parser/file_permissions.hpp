// Which files a scene may read and write. A scene is data from somewhere else: it reaches the folders that belong to the
// rendering, and nothing more unless the user allows it (as POV-Ray's I/O restrictions do).
//
// Without asking, a scene reads from its own folder, the current folder, the library paths and the folder of the picture, with
// everything below them; it writes to its own folder, the current folder and the folder of the picture.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lute {

// Absolute, with all links followed to the end, also to what does not exist yet: that is where a file would be made. Empty if the links
// go round in a circle.
std::filesystem::path true_path(const std::string& path);

class FilePermissions {
 public:
  // Allows a folder and all below it. "" is the current folder.
  void allow_read(const std::string& folder);
  void allow_write(const std::string& folder);

  bool may_read(const std::string& path) const;
  bool may_write(const std::string& path) const;

 private:
  std::vector<std::filesystem::path> read_, write_;  // absolute, without links and dots
};

}  // namespace lute
