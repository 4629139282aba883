#include "engine/output/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace lute {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw std::runtime_error("cannot write '" + path + "': " + reason);
}

std::string error_text() { return std::strerror(errno); }

// Creates a new file with the permissions that the user's umask gives.
std::string create_beside(const fs::path& target, const std::string& shown) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    const fs::path name = target.parent_path() / ("." + target.filename().string() + "." + std::to_string(getpid()) +
                                                  "." + std::to_string(attempt) + ".tmp");
    const int file = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0) {
      close(file);
      return name.string();
    }
    if (errno != EEXIST) fail(shown, error_text());
  }
  fail(shown, "no free temporary name");
}

struct Descriptor {
  int number;
  bool owned = true;
  ~Descriptor() {
    if (owned && number >= 0) close(number);
  }
};

void copy(const std::string& from, const std::string& to, bool to_stdout) {
  const Descriptor source{open(from.c_str(), O_RDONLY | O_CLOEXEC)};
  const Descriptor target{to_stdout ? STDOUT_FILENO : open(to.c_str(), O_WRONLY | O_CLOEXEC), !to_stdout};
  if (source.number < 0 || target.number < 0) fail(to, error_text());
  std::array<char, 65536> buffer;
  for (;;) {
    const ssize_t count = read(source.number, buffer.data(), buffer.size());
    if (count == 0) return;
    if (count < 0) fail(to, error_text());
    for (ssize_t done = 0; done < count;) {
      const ssize_t written = write(target.number, buffer.data() + done, static_cast<std::size_t>(count - done));
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(to, error_text());
      done += written;
    }
  }
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (path == "-" || (fs::exists(status) && !fs::is_regular_file(status))) {
    if (fs::is_directory(status)) fail(path, "it is a directory");
    copied_ = true;
    temporary_ = create_beside(fs::temp_directory_path() / "lute", path);
    return;
  }
  // Through a link to the file behind it, as writing in place would.
  fs::path target =
      fs::is_symlink(fs::symlink_status(path, ignored)) ? fs::weakly_canonical(path, ignored) : fs::path(path);
  if (target.empty()) target = path;
  path_ = target.string();
  if (fs::exists(status) && access(path_.c_str(), W_OK) != 0) fail(path, error_text());
  temporary_ = create_beside(target, path);
}

AtomicFile::~AtomicFile() {
  if (pending_) unlink(temporary_.c_str());
}

void AtomicFile::commit() {
  if (copied_) {
    copy(temporary_, path_, path_ == "-");
    return;  // the destructor removes the temporary file
  }
  if (rename(temporary_.c_str(), path_.c_str()) != 0) fail(path_, error_text());
  pending_ = false;
}

void check_writable(const std::string& path) { const AtomicFile trial(path); }

}  // namespace lute
