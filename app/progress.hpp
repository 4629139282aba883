// Progress on standard error: a bar on a terminal, else a plain line now and then.
#pragma once

#include <chrono>
#include <string>

namespace lute {

class Progress {
 public:
  Progress(std::string label, bool shown);
  ~Progress();  // clears the bar

  void update(long done, long total);

 private:
  void draw_bar(double share, double seconds);
  void print_line(long done, long total, double seconds);

  using Clock = std::chrono::steady_clock;
  std::string label_;
  bool shown_, terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace lute
