// The bound on recursion: the text of a scene must not be able to exhaust the stack.
#pragma once

#include "parser/session.hpp"

namespace lute {

// One level of parentheses, signs, calls or values in values.
class Nesting {
 public:
  explicit Nesting(Session& session) : depth_(session.expressions.depth) {
    if (depth_ >= session.options.limits.nesting) {
      session.fail("The expression is nested too deeply: the limit is " + std::to_string(session.options.limits.nesting) + ".",
                   "limit-nesting");
    }
    ++depth_;
  }
  ~Nesting() { --depth_; }
  Nesting(const Nesting&) = delete;
  Nesting& operator=(const Nesting&) = delete;

 private:
  std::size_t& depth_;
};

}  // namespace lute
