// The memory that this process may use: of the machine, of the control groups it runs in (versions 1 and 2), and by its resource
// limits. In bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace lute {

inline constexpr std::uint64_t kNoMemoryLimit = ~std::uint64_t{0};

// The smallest of all these limits. Address space that is mapped already without being in use (libraries) is taken off the limits on
// address space, so that the result compares with resident_bytes().
std::uint64_t machine_memory();

// What a limit on address space, in bytes, leaves to memory in use, of a process that has mapped and holds so many pages. At least 1.
std::uint64_t memory_under_limit(std::uint64_t limit, std::uint64_t mapped_pages, std::uint64_t resident_pages, std::uint64_t page_bytes);

// The smallest limit of the groups that `membership` (the text of /proc/self/cgroup) names and of those around them; `mount` is where
// the control groups are seen, /sys/fs/cgroup. kNoMemoryLimit if there is none.
std::uint64_t control_group_memory(std::string_view membership, const std::filesystem::path& mount);

// Memory that the process holds.
std::uint64_t resident_bytes();

}  // namespace lute
