#include "app/interrupt.hpp"

#include <signal.h>
#include <unistd.h>

#include <string_view>

namespace lute {
namespace {

// A signal handler reaches nothing but what is static.
std::atomic<bool> signalled{false};
std::atomic<int> guards{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void on_signal(int) {
  if (guards.load() > 0) {
    signalled.store(true);
    return;
  }
  constexpr std::string_view kMessage = "\nlute: interrupted\n";  // begins a line of its own below the progress bar
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kMessage.data(), kMessage.size());
  _exit(kInterruptedExit);
}

}  // namespace

void Interrupt::install() {
  struct sigaction action = {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction old = {};
    // A program started to ignore hang-ups (nohup) keeps ignoring them.
    if (sigaction(signal, nullptr, &old) == 0 && old.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

const std::atomic<bool>& Interrupt::flag() { return signalled; }

Interrupt::Guard::Guard() { guards.fetch_add(1); }
Interrupt::Guard::~Guard() { guards.fetch_sub(1); }

}  // namespace lute
