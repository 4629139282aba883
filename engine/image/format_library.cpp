#include "engine/image/format_library.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

namespace lute {
namespace {

struct Opened {
  const FormatLibrary* library = nullptr;
  std::string error;
};

// Beside the program first (as installed: bin/../lib/lute), then where the build has put it.
std::vector<std::string> candidates() {
  std::vector<std::string> paths;
  std::error_code ignored;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  if (!program.empty()) {
    paths.push_back((program.parent_path() / "lute_openimageio.so").string());
    paths.push_back((program.parent_path().parent_path() / "lib/lute/lute_openimageio.so").string());
  }
  paths.push_back(LUTE_MODULE_DIR "/lute_openimageio.so");
  return paths;
}

Opened open_module() {
  Opened opened;
  for (const std::string& path : candidates()) {
    // Never closed: the libraries behind it register things for the end of the process.
    void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) {
      opened.error = dlerror();
      continue;
    }
    using Entry = const FormatLibrary* (*)();
    if (const auto entry = reinterpret_cast<Entry>(dlsym(handle, "lute_format_library"))) {
      opened.library = entry();
      opened.error.clear();
      return opened;
    }
    opened.error = path + " is not a module of lute";
  }
  return opened;
}

}  // namespace

const FormatLibrary* format_library(std::string& error) {
  static const Opened opened = open_module();
  error = opened.error;
  return opened.library;
}

}  // namespace lute
