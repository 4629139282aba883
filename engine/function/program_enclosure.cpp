// Programs in interval arithmetic. A branch whose condition is not decided over the range is followed both ways.
#include <algorithm>
#include <vector>

#include "engine/function/enclosure.hpp"
#include "engine/function/program.hpp"

namespace lute {

bool Function::enclose(const Enclosure*, Enclosure*) const { return false; }

class Program::Enclosing {
 public:
  explicit Enclosing(const Program& program) : program_(program) {}

  // The result of running from instruction `pc` to the end; `r` is left in disorder.
  bool run(std::size_t pc, std::vector<Enclosure>& r, Enclosure& result) {
    for (;;) {
      if (++steps_ > kMostSteps) return false;
      const Instruction& i = program_.code_[pc++];
      switch (i.op) {
        case Op::kUnary:
        case Op::kNegate:
        case Op::kAbs:
        case Op::kSqrt:
        case Op::kSin:
        case Op::kCos: r[i.target] = lute::enclose(static_cast<UnaryOp>(i.detail), r[i.a]); break;
        case Op::kBinary:
        case Op::kAdd:
        case Op::kSubtract:
        case Op::kMultiply: r[i.target] = lute::enclose(static_cast<BinaryOp>(i.detail), r[i.a], r[i.b]); break;
        case Op::kMultiplyAdd:
          r[i.target] = lute::enclose(BinaryOp::kAdd, lute::enclose(BinaryOp::kMultiply, r[i.a], r[i.b]), r[i.c]);
          break;
        case Op::kMove: r[i.target] = r[i.a]; break;
        case Op::kCall: {
          Enclosure out[kMostResults];
          if (!program_.callees_[i.b]->enclose(&r[i.a], out)) return false;
          r[i.target] = out[i.detail];
          break;
        }
        case Op::kJump: pc = i.c; break;
        case Op::kEnterLoop:
        case Op::kLeaveLoop: break;
        case Op::kReturn: result = r[program_.result_]; return true;
        default: {
          const Enclosure holds = condition(i, r);
          if (holds.is_point()) {
            if (holds.lo == 0) pc = i.c;
            break;
          }
          std::vector<Enclosure> other = r;
          Enclosure a, b;
          if (!run(pc, r, a) || !run(i.c, other, b)) return false;
          result = either(a, b);
          return true;
        }
      }
    }
  }

  static constexpr int kMostSteps = 4000;  // loops and branches within branches

 private:
  static Enclosure condition(const Instruction& i, const std::vector<Enclosure>& r) {
    switch (i.op) {
      case Op::kJumpUnlessNegative: return lute::enclose(BinaryOp::kLess, r[i.a], 0);
      case Op::kJumpUnlessZero: return lute::enclose(BinaryOp::kEqual, r[i.a], 0);
      default: return lute::enclose(BinaryOp::kLessEqual, r[i.a], r[i.b]);
    }
  }

  const Program& program_;
  int steps_ = 0;
};

bool Program::enclose(const Enclosure* arguments, Enclosure* results) const {
  if (work() > Enclosing::kMostSteps) return false;  // its calls alone are more
  thread_local std::vector<std::vector<Enclosure>> spare;  // programs call programs
  std::vector<Enclosure> registers;
  if (!spare.empty()) {
    registers = std::move(spare.back());
    spare.pop_back();
  }
  registers.resize(register_count_);
  std::copy_n(arguments, parameter_count(), registers.begin());
  std::copy(constants_.begin(), constants_.end(), registers.begin() + parameter_count());
  const bool known = Enclosing(*this).run(0, registers, results[0]);
  spare.push_back(std::move(registers));
  return known;
}

}  // namespace lute
