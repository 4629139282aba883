#include "parser/file_permissions.hpp"

#include <algorithm>
#include <deque>

namespace lute {

namespace fs = std::filesystem;

namespace {

fs::path absolute(const std::string& path) {
  std::error_code error;
  const fs::path result = fs::absolute(path.empty() ? fs::path(".") : fs::path(path), error);
  return error ? fs::path(path) : result;
}

}  // namespace

fs::path true_path(const std::string& path) {
  constexpr int kMostLinks = 40;  // the system follows no more
  const fs::path name = absolute(path);
  std::deque<fs::path> left(name.begin(), name.end());
  fs::path at;
  for (int links = 0; !left.empty();) {
    const fs::path part = left.front();
    left.pop_front();
    if (part.empty() || part == ".") continue;
    if (part == "..") {
      at = at.parent_path();
      continue;
    }
    const fs::path next = at / part;
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(next, error))) {
      at = next;
      continue;
    }
    const fs::path target = fs::read_symlink(next, error);
    if (error || ++links > kMostLinks) return {};
    left.insert(left.begin(), target.begin(), target.end());  // an absolute one begins with the root, which replaces `at`
  }
  return at;
}

namespace {

bool is_below(const fs::path& path, const fs::path& folder) {
  const auto [rest_of_folder, rest_of_path] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return rest_of_folder == folder.end() || (rest_of_folder->empty() && std::next(rest_of_folder) == folder.end());
}

bool is_below_any(const fs::path& path, const std::vector<fs::path>& folders) {
  return std::ranges::any_of(folders, [&](const fs::path& folder) { return is_below(path, folder); });
}

void add(std::vector<fs::path>& folders, const std::string& folder) {
  folders.push_back(true_path(folder));
  // Also by the name it was given: its entries may be links, set there by the folder's owner.
  folders.push_back(absolute(folder).lexically_normal());
}

}  // namespace

void FilePermissions::allow_read(const std::string& folder) { add(read_, folder); }
void FilePermissions::allow_write(const std::string& folder) { add(write_, folder); }

bool FilePermissions::may_read(const std::string& path) const {
  if (is_below_any(true_path(path), read_)) return true;
  // A link inside an allowed folder may be read through, but not left upwards again.
  const fs::path name = absolute(path);
  const bool climbs = std::ranges::find(name, fs::path("..")) != name.end();
  return !climbs && is_below_any(name.lexically_normal(), read_);
}

// Links are never written through.
bool FilePermissions::may_write(const std::string& path) const { return is_below_any(true_path(path), write_); }

}  // namespace lute
