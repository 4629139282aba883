// A file that appears complete or not at all: written beside its final name under a name of its own, then renamed.
#pragma once

#include <string>

namespace lute {

class AtomicFile {
 public:
  // Creates the temporary file, empty. Throws std::runtime_error where the place cannot be written. "-" stands for
  // standard output; it and whatever is no regular file (a device, a pipe) get the content copied when it is complete.
  explicit AtomicFile(const std::string& path);
  ~AtomicFile();  // without commit(): nothing is left behind
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::string& temporary_path() const { return temporary_; }
  void commit();  // throws std::runtime_error

 private:
  std::string path_, temporary_;
  bool copied_ = false;  // into a stream or device, in place of renamed
  bool pending_ = true;
};

// Throws std::runtime_error if `path` could not be written now: asked before a long render, not after it.
void check_writable(const std::string& path);

}  // namespace lute
