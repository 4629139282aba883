#include "parser/machine_memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

namespace lute {

namespace {

struct ProcessPages {
  std::uint64_t mapped = 0, resident = 0;
};

ProcessPages process_pages() {
  std::FILE* const file = std::fopen("/proc/self/statm", "r");
  if (file == nullptr) return {};
  unsigned long long mapped = 0, resident = 0;
  const int found = std::fscanf(file, "%llu %llu", &mapped, &resident);
  std::fclose(file);
  return found == 2 ? ProcessPages{mapped, resident} : ProcessPages{};
}

std::uint64_t page_bytes() { return static_cast<std::uint64_t>(std::max(sysconf(_SC_PAGESIZE), 4096L)); }

// "max" or a number; a huge one stands for none.
std::uint64_t limit_in(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::uint64_t limit = 0;
  return stream >> limit && limit > 0 ? limit : kNoMemoryLimit;
}

// The group's own limit and those of the groups it lies in. Inside a container the mount shows the group itself as the root, so that
// folders of the path may be missing.
std::uint64_t group_limit(const std::filesystem::path& mount, std::string_view group, const char* file) {
  std::uint64_t least = limit_in(mount / file);
  std::filesystem::path folder = mount;
  for (const std::filesystem::path& part : std::filesystem::path(group).relative_path()) {
    folder /= part;
    least = std::min(least, limit_in(folder / file));
  }
  return least;
}

bool names_memory(std::string_view controllers) {
  while (!controllers.empty()) {
    const std::size_t end = std::min(controllers.find(','), controllers.size());
    if (controllers.substr(0, end) == "memory") return true;
    controllers.remove_prefix(std::min(end + 1, controllers.size()));
  }
  return false;
}

std::uint64_t resource_limit(int resource) {
  rlimit limit{};
  if (getrlimit(static_cast<decltype(RLIMIT_AS)>(resource), &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kNoMemoryLimit;
  const ProcessPages pages = process_pages();
  return memory_under_limit(limit.rlim_cur, pages.mapped, pages.resident, page_bytes());
}

}  // namespace

std::uint64_t memory_under_limit(std::uint64_t limit, std::uint64_t mapped_pages, std::uint64_t resident_pages,
                                 std::uint64_t page_bytes) {
  const std::uint64_t unused = mapped_pages > resident_pages ? (mapped_pages - resident_pages) * page_bytes : 0;
  return limit > unused ? limit - unused : 1;
}

std::uint64_t control_group_memory(std::string_view membership, const std::filesystem::path& mount) {
  std::uint64_t least = kNoMemoryLimit;
  // Each line is NUMBER:CONTROLLERS:GROUP; version 2 names no controllers.
  while (!membership.empty()) {
    const std::size_t end = std::min(membership.find('\n'), membership.size());
    const std::string_view line = membership.substr(0, end);
    membership.remove_prefix(std::min(end + 1, membership.size()));
    const std::size_t first = line.find(':');
    const std::size_t second = first == std::string_view::npos ? first : line.find(':', first + 1);
    if (second == std::string_view::npos) continue;
    const std::string_view controllers = line.substr(first + 1, second - first - 1), group = line.substr(second + 1);
    if (controllers.empty()) least = std::min(least, group_limit(mount, group, "memory.max"));
    if (names_memory(controllers)) least = std::min(least, group_limit(mount / "memory", group, "memory.limit_in_bytes"));
  }
  return least;
}

std::uint64_t machine_memory() {
  std::ifstream file("/proc/self/cgroup");
  const std::string membership(std::istreambuf_iterator<char>(file), {});
  const std::uint64_t physical = static_cast<std::uint64_t>(std::max(sysconf(_SC_PHYS_PAGES), 1L)) * page_bytes();
  return std::min({physical, control_group_memory(membership, "/sys/fs/cgroup"), resource_limit(RLIMIT_AS), resource_limit(RLIMIT_DATA)});
}

std::uint64_t resident_bytes() { return process_pages().resident * page_bytes(); }

}  // namespace lute
