// Names of files that tests write: unique to the process, since each test runs as its own and many run at once.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace lute {

inline std::string temporary_path(std::string_view name) {
  return (std::filesystem::temp_directory_path() / ("lute_" + std::to_string(::getpid()) + "_" + std::string(name))).string();
}

}  // namespace lute
