// What a scene may use up while it is read, so that a hostile or mistaken one ends with a clear error instead of the machine's
// memory or patience. Each limit has a switch of its own.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lute {

struct ParseLimits {
  std::size_t errors = 20;                      // reading ends with this one
  std::size_t nesting = 200;                    // parentheses, vectors and calls inside one expression
  std::size_t blocks = 1000;                    // braces in each other
  std::size_t depth = 1000;                     // objects, textures and functions made of each other by their names
  std::uint64_t loop_turns = 1'000'000'000ull;  // of all loops together
  std::uint64_t tokens = 4'000'000'000ull;      // taken from the text, loops and macros included
  std::uint64_t memory_bytes = 0;               // of the process; 0: three quarters of machine_memory()
  std::uint64_t file_bytes = 0xFFFF'FFF0ull;    // of one file: offsets are 32 bits
};

}  // namespace lute
