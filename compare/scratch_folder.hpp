// A temporary working directory that looks like the folder of a scene.
//
// Scenes read files beside them by relative names, and some write files there. Both renderers therefore run in a fresh
// folder with the same entries: small files are copies, large files and folders are links, so nothing that a scene
// writes reaches the original.
#pragma once

#include <filesystem>

namespace lute::compare {

class ScratchFolder {
 public:
  ScratchFolder();                                              // empty
  explicit ScratchFolder(const std::filesystem::path& folder);  // with the entries of this folder
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace lute::compare
