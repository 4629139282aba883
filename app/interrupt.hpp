// Ctrl-C, SIGTERM and SIGHUP: lute stops at once, in the middle of whatever it reads or traces; only a file that is being
// written is finished first. The exit code is then 130.
#pragma once

#include <atomic>

namespace lute {

constexpr int kInterruptedExit = 130;

class Interrupt {
 public:
  static void install();

  // Set by a signal while a Guard is alive.
  static const std::atomic<bool>& flag();

  // While one is alive a signal only sets the flag.
  class Guard {
   public:
    Guard();
    ~Guard();
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;
  };
};

}  // namespace lute
