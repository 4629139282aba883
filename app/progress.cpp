#include "app/progress.hpp"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace lute {
namespace {

constexpr std::chrono::milliseconds kBarInterval{100};
constexpr std::chrono::seconds kLineInterval{5};
constexpr int kBarWidth = 40;

double seconds_of(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

// How long the rest takes at the pace so far.
double remaining(double share, double seconds) { return share > 0 ? seconds * (1 - share) / share : 0; }

}  // namespace

Progress::Progress(std::string label, bool shown)
    : label_(std::move(label)), shown_(shown), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_ && terminal_) std::fputs("\r\033[K", stderr);
}

void Progress::update(long done, long total) {
  if (!shown_ || total <= 0) return;
  const Clock::time_point now = Clock::now();
  if (terminal_) {
    if (now - last_ < kBarInterval) return;
    draw_bar(static_cast<double>(done) / static_cast<double>(total), seconds_of(now - start_));
  } else {
    if (now - last_ < kLineInterval) return;
    print_line(done, total, seconds_of(now - start_));
  }
  last_ = now;
  drawn_ = true;
}

void Progress::draw_bar(double share, double seconds) {
  std::string bar(kBarWidth, '.');
  bar.replace(0, static_cast<std::size_t>(share * kBarWidth), static_cast<std::size_t>(share * kBarWidth), '#');
  std::fprintf(stderr, "\r%s [%s] %3.0f %%  %.0f s left\033[K", label_.c_str(), bar.c_str(), 100 * share,
               remaining(share, seconds));
  std::fflush(stderr);
}

void Progress::print_line(long done, long total, double seconds) {
  const double share = static_cast<double>(done) / static_cast<double>(total);
  std::fprintf(stderr, "%s: rendered %ld of %ld pixels (%.0f %%), %.0f s left\n", label_.c_str(), done, total,
               100 * share, remaining(share, seconds));
}

}  // namespace lute
