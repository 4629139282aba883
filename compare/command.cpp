#include "compare/command.hpp"

#include <cstdio>
#include <filesystem>
#include <system_error>

namespace lute::compare {

void parse_size(const std::string& text, int& width, int& height) {
  char rest = 0;
  const bool complete = std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2;
  if (!complete || width <= 0 || height <= 0)
    throw CLI::ValidationError("--size", "wants WIDTHxHEIGHT, not '" + text + "'");
}

std::string default_lute_program() {
  std::error_code error;
  const std::filesystem::path beside = std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / "lute";
  return !error && std::filesystem::exists(beside, error) ? beside.string() : "lute";
}

}  // namespace lute::compare
