// The loops of sum() and prod() that are open in this thread, over all programs that call each other: each may be short and all together
// endless.
#pragma once

#include <limits>

#include "engine/function/program.hpp"

namespace lute {

struct OpenLoops {
  int depth = 0;
  double turns = 0;

  // How often a loop turns, what one turn calls included: 0 if not once, infinite if counting would not end.
  static double turns_of(double from, double to, double calls) {
    constexpr double kLargestCounted = 4503599627370496;  // adding 1 changes what is smaller
    if (!(from <= to)) return 0;
    if (from < -kLargestCounted || to > kLargestCounted) return std::numeric_limits<double>::infinity();
    return to - from + calls;
  }

  void enter(double more_turns, double calls) {
    if (depth == 0) turns = 0;
    turns += more_turns;
    if (!(turns <= kMostTurns)) {
      depth = 0;
      throw calls > 0 ? EndlessFunction::calls() : EndlessFunction::loops();
    }
    ++depth;
  }
};

inline OpenLoops& open_loops() {
  thread_local OpenLoops loops;
  return loops;
}

}  // namespace lute
