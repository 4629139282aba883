#include "compare/scratch_folder.hpp"

#include <stdlib.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace lute::compare {
namespace fs = std::filesystem;

namespace {
constexpr std::uintmax_t kLargestCopy = 1 << 20;
}

ScratchFolder::ScratchFolder() {
  std::string name = (fs::temp_directory_path() / "lute-compare-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), "cannot make a temporary folder " + name);
  }
  path_ = name;
}

ScratchFolder::ScratchFolder(const fs::path& folder) : ScratchFolder() {
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::absolute(folder))) {
    std::error_code ignored;  // an entry that cannot be read is missing for both programs alike
    const fs::path target = path_ / entry.path().filename();
    if (entry.is_regular_file(ignored) && entry.file_size(ignored) <= kLargestCopy) {
      fs::copy_file(entry.path(), target, ignored);
    } else {
      fs::create_symlink(entry.path(), target, ignored);
    }
  }
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace lute::compare
