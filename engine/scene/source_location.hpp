// Where in the scene's text something was written.
#pragma once

#include <cstdint>

namespace lute {

struct SourceLocation {
  std::uint32_t file = 0;    // index into Scene::files (and the parser's file table)
  std::uint32_t line = 0;    // from 1; 0: nowhere (built in)
  std::uint32_t column = 0;  // from 1, in bytes
};

}  // namespace lute
