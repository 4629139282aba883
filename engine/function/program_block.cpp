// Programs run over a block of points at once: what an instruction costs beside its arithmetic is paid once a block.
//
// Points that take different branches, or leave a loop at different turns, wait for each other: always those go on that are the farthest
// back. Code is structured (a jump back only closes a loop), so that all meet again where the branches join, and no point ever runs an
// instruction that it would not run alone.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "engine/function/open_loops.hpp"
#include "engine/function/program.hpp"

namespace lute {

namespace {

constexpr std::size_t kBlock = 32;
constexpr std::size_t kFew = 8;  // fewer points are faster one by one, above all where they take different branches
constexpr std::size_t kMostRegisters = 4096;  // a block of them is 1 MB

// Four doubles that are worked on at once, in one register or two.
using Four = double __attribute__((vector_size(32)));

}  // namespace

void Function::one_by_one(std::size_t count, std::size_t stride, const double* arguments, double* results) const {
  std::array<double, 16> few;
  std::vector<double> many;
  double* point = few.data();
  const auto parameters = static_cast<std::size_t>(parameter_count()), of_each = static_cast<std::size_t>(result_count());
  if (parameters > few.size()) {
    many.resize(parameters);
    point = many.data();
  }
  for (std::size_t i = 0; i < count; ++i) {
    double out[kMostResults];
    for (std::size_t k = 0; k < parameters; ++k) point[k] = arguments[k * stride + i];
    evaluate(point, out);
    for (std::size_t k = 0; k < of_each; ++k) results[k * stride + i] = out[k];
  }
}

// A row of kBlock numbers for each register.
class Program::Block {
 public:
  // For no more than `most` points.
  Block(const Program& program, std::size_t most) : program_(program) {
    if (!spare().empty()) {
      registers_ = std::move(spare().back());
      spare().pop_back();
    }
    if (registers_.size() < program.register_count_ * kBlock) registers_.resize(program.register_count_ * kBlock);
    double* constant = row(program.parameter_count());
    for (const double c : program.constants_) {
      for (std::size_t i = 0; i < most; ++i) constant[i] = c;
      constant += kBlock;
    }
  }
  ~Block() { spare().push_back(std::move(registers_)); }
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;

  void run(std::size_t count, std::size_t stride, const double* arguments, double* results) {
    for (int k = 0; k < program_.parameter_count(); ++k) std::copy_n(arguments + static_cast<std::size_t>(k) * stride, count, row(k));
    count_ = count;
    all_run();
    for (Place place = 0;;) {
      if (place == meeting_) meet();
      const Instruction& i = program_.code_[place];
      if (i.op == Op::kReturn) break;
      place = step(i, place + 1);
    }
    std::copy_n(row(program_.result_), count, results);
  }

 private:
  using Place = std::size_t;
  static constexpr Place kRuns = std::numeric_limits<Place>::max();

  static std::vector<std::vector<double>>& spare() {  // programs call programs
    thread_local std::vector<std::vector<double>> blocks;
    return blocks;
  }

  template <class Index>
  double* row(Index index) {
    return registers_.data() + static_cast<std::size_t>(index) * kBlock;
  }

  // Calls f with the number of each point that runs.
  template <class F>
  void each(F f) const {
    if (running_count_ == count_)
      for (std::size_t i = 0; i < count_; ++i) f(i);
    else
      for (std::size_t j = 0; j < running_count_; ++j) f(running_[j]);
  }

  // The same for arithmetic, which may as well be done with what lies behind the points in a row.
  template <class F>
  void arithmetic(const Instruction& i, F f) {
    const double *a = row(i.a), *b = row(i.b);
    double* target = row(i.target);
    if (running_count_ != count_) {
      for (std::size_t j = 0; j < running_count_; ++j) {
        double result = a[running_[j]];
        f(result, b[running_[j]]);
        target[running_[j]] = result;
      }
      return;
    }
    for (std::size_t begin = 0; begin < count_; begin += 4) {
      Four result, right;
      std::memcpy(&result, a + begin, sizeof result);
      std::memcpy(&right, b + begin, sizeof right);
      f(result, right);
      std::memcpy(target + begin, &result, sizeof result);
    }
  }

  // Runs one instruction; where to go on.
  Place step(const Instruction& i, Place next) {
    const double *a = row(i.a), *b = row(i.op == Op::kCall ? i.a : i.b);
    double* target = row(i.target);
    switch (i.op) {
      case Op::kAdd: arithmetic(i, [](auto& x, const auto& y) { x += y; }); break;
      case Op::kSubtract: arithmetic(i, [](auto& x, const auto& y) { x -= y; }); break;
      case Op::kMultiply: arithmetic(i, [](auto& x, const auto& y) { x *= y; }); break;
      case Op::kMultiplyAdd: {
        const double* c = row(i.c);
        arithmetic(i, [](auto& x, const auto& y) { x *= y; });
        each([&](std::size_t p) { target[p] += c[p]; });
        break;
      }
      case Op::kNegate: arithmetic(i, [](auto& x, const auto&) { x = -x; }); break;
      case Op::kAbs: each([&](std::size_t p) { target[p] = std::fabs(a[p]); }); break;
      case Op::kSqrt: each([&](std::size_t p) { target[p] = std::sqrt(a[p]); }); break;
      case Op::kSin: each([&](std::size_t p) { target[p] = std::sin(a[p]); }); break;
      case Op::kCos: each([&](std::size_t p) { target[p] = std::cos(a[p]); }); break;
      case Op::kUnary: each([&](std::size_t p) { target[p] = apply(static_cast<UnaryOp>(i.detail), a[p]); }); break;
      case Op::kBinary:
        if (static_cast<BinaryOp>(i.detail) == BinaryOp::kDivide)
          arithmetic(i, [](auto& x, const auto& y) { x /= y; });
        else
          each([&](std::size_t p) { target[p] = apply(static_cast<BinaryOp>(i.detail), a[p], b[p]); });
        break;
      case Op::kMove: each([&](std::size_t p) { target[p] = a[p]; }); break;
      case Op::kCall: call(i); break;
      case Op::kJump: return jump(i.c);
      case Op::kJumpUnlessNegative: return jump_unless(i.c, next, [&](std::size_t p) { return a[p] < 0; });
      case Op::kJumpUnlessZero: return jump_unless(i.c, next, [&](std::size_t p) { return a[p] == 0; });
      case Op::kJumpUnlessLessEqual: return jump_unless(i.c, next, [&](std::size_t p) { return a[p] <= b[p]; });
      case Op::kEnterLoop: {
        double turns = 0;  // of the point with most: a bound for all of them
        each([&](std::size_t p) { turns = std::max(turns, OpenLoops::turns_of(a[p], b[p], i.c)); });
        open_loops().enter(turns, i.c);
        break;
      }
      case Op::kLeaveLoop: --open_loops().depth; break;
      case Op::kReturn: break;
    }
    return next;
  }

  // Those that wait are left out.
  void call(const Instruction& i) {
    const Function& callee = *program_.callees_[i.b];
    const auto parameters = static_cast<std::size_t>(callee.parameter_count());
    std::array<double, kMostResults * kBlock> out;
    const double* arguments = row(i.a);
    std::vector<double> chosen;
    if (running_count_ != count_) {
      chosen.resize(parameters * kBlock);
      for (std::size_t k = 0; k < parameters; ++k)
        for (std::size_t j = 0; j < running_count_; ++j) chosen[k * kBlock + j] = arguments[k * kBlock + running_[j]];
      arguments = chosen.data();
    }
    callee.evaluate_many(running_count_, kBlock, arguments, out.data());
    const double* results = out.data() + i.detail * kBlock;
    double* target = row(i.target);
    each([&](std::size_t p) { target[p] = *results++; });
  }

  void all_run() {
    std::fill_n(waits_.begin(), count_, kRuns);
    meeting_ = kRuns;
    running_count_ = count_;
  }

  // Those that wait at the meeting go on.
  void meet() {
    Place later = kRuns;
    running_count_ = 0;
    for (std::size_t p = 0; p < count_; ++p) {
      if (waits_[p] == meeting_) waits_[p] = kRuns;
      if (waits_[p] == kRuns) running_[running_count_++] = static_cast<std::uint8_t>(p);
      later = std::min(later, waits_[p]);
    }
    meeting_ = later;
  }

  // All that run go to `place`, or wait there if others are farther back.
  Place jump(Place place) {
    if (place <= meeting_) return place;
    each([&](std::size_t p) { waits_[p] = place; });
    running_count_ = 0;
    return meeting_;
  }

  template <class Condition>
  Place jump_unless(Place place, Place next, Condition holds) {
    std::array<std::uint8_t, kBlock> go_on;
    std::size_t count = 0;
    each([&](std::size_t p) {
      go_on[count] = static_cast<std::uint8_t>(p);
      count += holds(p) ? 1 : 0;
    });
    if (count == running_count_) return next;
    if (count == 0) return jump(place);
    std::size_t kept = 0;
    each([&](std::size_t p) {
      if (kept < count && go_on[kept] == p)
        ++kept;
      else
        waits_[p] = place;
    });
    std::copy_n(go_on.begin(), count, running_.begin());
    running_count_ = count;
    meeting_ = std::min(meeting_, place);
    return next;
  }

  const Program& program_;
  std::vector<double> registers_;
  std::size_t count_ = 0;
  std::array<Place, kBlock> waits_;           // where each point waits, or kRuns
  Place meeting_ = kRuns;                     // the first place where points wait
  std::array<std::uint8_t, kBlock> running_;  // the points that run, ascending; not kept where all do
  std::size_t running_count_ = 0;
};

void Program::evaluate_many(std::size_t count, std::size_t stride, const double* arguments, double* results) const {
  if (count < kFew || register_count_ > kMostRegisters) return one_by_one(count, stride, arguments, results);
  Block block(*this, std::min(count, kBlock));
  for (std::size_t begin = 0; begin < count; begin += kBlock) {
    const std::size_t points = std::min(kBlock, count - begin);
    const OpenLoops before = open_loops();
    try {
      block.run(points, stride, arguments + begin, results + begin);
    } catch (const EndlessFunction&) {
      // Of a block the turns are only bounded, by the point with most each time.
      open_loops() = before;
      one_by_one(points, stride, arguments + begin, results + begin);
    }
  }
}

}  // namespace lute
