// Keeps a parse within its limits: tokens taken, loop turns, memory. Cheap enough to be asked at every token; the memory of the
// process is measured now and then, and whenever much was allocated at once.
#pragma once

#include <cstdint>

#include "parser/parse_limits.hpp"

namespace lute {

struct Session;

class ResourceMeter {
 public:
  ResourceMeter(Session& session, const ParseLimits& limits);

  void count_token() {
    if (++tokens_ >= next_check_) check_tokens();
  }
  void count_turn() {
    if (++turns_ > limits_.loop_turns) fail_turns();
  }
  // Called before this much is allocated at the scene's wish.
  void charge(std::uint64_t bytes);
  // This much will be needed beside what the process has when the scene is read.
  void reserve(double bytes);
  // Fails if so much cannot be had at all.
  void require(double bytes) {
    if (bytes > static_cast<double>(memory_limit_)) fail_memory();
  }

  std::uint64_t memory_limit() const { return memory_limit_; }

 private:
  void check_tokens();
  void check_memory(std::uint64_t wanted);
  [[noreturn]] void fail_turns();
  [[noreturn]] void fail_memory();

  Session& session_;
  const ParseLimits& limits_;
  std::uint64_t memory_limit_;
  std::uint64_t tokens_ = 0, turns_ = 0, next_check_;
  std::uint64_t charged_ = 0;  // since memory was measured last
  std::uint64_t reserved_ = 0;
};

}  // namespace lute
