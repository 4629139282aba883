#include "engine/function/program.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include "engine/function/open_loops.hpp"

namespace lute {

void Program::evaluate(const double* arguments, double* results) const {
  constexpr std::size_t kOnStack = 128;
  std::array<double, kOnStack> fixed;  // not initialised: every register is written before it is read
  std::vector<double> large;
  double* r = fixed.data();
  if (register_count_ > kOnStack) {
    large.resize(register_count_);
    r = large.data();
  }
  std::copy_n(arguments, parameter_count(), r);
  std::copy(constants_.begin(), constants_.end(), r + parameter_count());

  const Instruction* const code = code_.data();
  for (const Instruction* i = code;;) {
    const Instruction& now = *i++;
    switch (now.op) {
      case Op::kAdd: r[now.target] = r[now.a] + r[now.b]; break;
      case Op::kSubtract: r[now.target] = r[now.a] - r[now.b]; break;
      case Op::kMultiply: r[now.target] = r[now.a] * r[now.b]; break;
      case Op::kMultiplyAdd: r[now.target] = r[now.a] * r[now.b] + r[now.c]; break;
      case Op::kNegate: r[now.target] = -r[now.a]; break;
      case Op::kAbs: r[now.target] = std::fabs(r[now.a]); break;
      case Op::kSqrt: r[now.target] = std::sqrt(r[now.a]); break;
      case Op::kSin: r[now.target] = std::sin(r[now.a]); break;
      case Op::kCos: r[now.target] = std::cos(r[now.a]); break;
      case Op::kUnary: r[now.target] = apply(static_cast<UnaryOp>(now.detail), r[now.a]); break;
      case Op::kBinary: r[now.target] = apply(static_cast<BinaryOp>(now.detail), r[now.a], r[now.b]); break;
      case Op::kMove: r[now.target] = r[now.a]; break;
      case Op::kCall: {
        double out[kMostResults];
        callees_[now.b]->evaluate(r + now.a, out);
        r[now.target] = out[now.detail];
        break;
      }
      case Op::kJump: i = code + now.c; break;
      case Op::kJumpUnlessNegative: if (!(r[now.a] < 0)) i = code + now.c; break;
      case Op::kJumpUnlessZero: if (!(r[now.a] == 0)) i = code + now.c; break;
      case Op::kJumpUnlessLessEqual: if (!(r[now.a] <= r[now.b])) i = code + now.c; break;
      case Op::kEnterLoop: open_loops().enter(OpenLoops::turns_of(r[now.a], r[now.b], now.c), now.c); break;
      case Op::kLeaveLoop: --open_loops().depth; break;
      case Op::kReturn: results[0] = r[result_]; return;
      default: __builtin_unreachable();  // spares a comparison for each instruction
    }
  }
}

Program::Op Program::op_of(UnaryOp op) {
  switch (op) {
    case UnaryOp::kNegate: return Op::kNegate;
    case UnaryOp::kAbs: return Op::kAbs;
    case UnaryOp::kSqrt: return Op::kSqrt;
    case UnaryOp::kSin: return Op::kSin;
    case UnaryOp::kCos: return Op::kCos;
    default: return Op::kUnary;
  }
}

Program::Op Program::op_of(BinaryOp op) {
  switch (op) {
    case BinaryOp::kAdd: return Op::kAdd;
    case BinaryOp::kSubtract: return Op::kSubtract;
    case BinaryOp::kMultiply: return Op::kMultiply;
    default: return Op::kBinary;
  }
}

// Turns the expression into code. A node computed outside a branch or loop is known inside it, not the other way round: the
// registers learnt inside are forgotten at its end.
class ProgramEmitter {
 public:
  ProgramEmitter(const ExpressionBuilder& builder, int parameter_count) : builder_(builder), program_(parameter_count) {
    program_.callees_ = builder.callees_;
    for (ExpressionBuilder::Node n = 0; n < builder.nodes_.size(); ++n)
      if (builder.nodes_[n].kind == Kind::kConstant) constant_register(builder.nodes_[n].value);
    reciprocals();
    next_register_ = static_cast<std::size_t>(parameter_count) + program_.constants_.size();
  }

  Program emit(ExpressionBuilder::Node root) {
    uses_.resize(builder_.nodes_.size());
    for (const auto& data : builder_.nodes_)
      for (const Node input : data.inputs) ++uses_[input];
    program_.result_ = node(root);
    jump(Op::kReturn);
    program_.register_count_ = next_register_;
    std::uint32_t depth = 0;
    for (const FunctionPtr& callee : program_.callees_) depth = std::max(depth, callee->depth());
    program_.set_calls(depth + 1, work_);
    return std::move(program_);
  }

 private:
  using Kind = ExpressionBuilder::Kind;
  using Op = Program::Op;
  using Node = ExpressionBuilder::Node;
  using Register = std::uint16_t;

  // Division by a constant is a multiplication by its reciprocal, small powers are multiplications (chapter 10 §11.3).
  void reciprocals() {
    for (const auto& data : builder_.nodes_)
      if (double c = 0; data.kind == Kind::kBinary && static_cast<BinaryOp>(data.detail) == BinaryOp::kDivide &&
                        builder_.is_constant(data.inputs[1], &c))
        constant_register(1.0 / c);
    constant_register(0);
    constant_register(1);
  }

  Register constant_register(double value) {
    auto& constants = program_.constants_;
    const auto same = [&](double c) { return std::bit_cast<std::uint64_t>(c) == std::bit_cast<std::uint64_t>(value); };
    auto it = std::find_if(constants.begin(), constants.end(), same);
    if (it == constants.end()) it = constants.insert(constants.end(), value);
    return static_cast<Register>(program_.parameter_count() + (it - constants.begin()));
  }

  Register new_register() {
    if (next_register_ >= 65535) throw std::length_error("function needs more than 65535 intermediate values");
    return static_cast<Register>(next_register_++);
  }

  Register push(Op op, std::uint8_t detail, Register a, Register b = 0) {
    const Register target = new_register();
    program_.code_.push_back({op, detail, target, a, b, 0});
    return target;
  }
  void move(Register target, Register source) { program_.code_.push_back({Op::kMove, 0, target, source, 0, 0}); }
  std::size_t jump(Op op, Register a = 0, Register b = 0) {
    program_.code_.push_back({op, 0, 0, a, b, 0});
    return program_.code_.size() - 1;
  }
  void land(std::size_t jump_index) { program_.code_[jump_index].c = static_cast<std::uint32_t>(program_.code_.size()); }
  Register multiply(Register a, Register b) {
    return push(Op::kMultiply, static_cast<std::uint8_t>(BinaryOp::kMultiply), a, b);
  }

  Register node(Node n) {
    if (const auto it = registers_.find(n); it != registers_.end()) return it->second;
    const Register r = compute(builder_.nodes_[n]);
    registers_.emplace(n, r);
    learnt_.push_back(n);
    return r;
  }

  // Emits `n` where it may not always run.
  void inside(Node n, Register target) {
    const std::size_t mark = learnt_.size();
    move(target, node(n));
    forget(mark);
  }
  // The same for one of several branches: the costliest one counts.
  void branch(Node n, Register target, double before, double& most) {
    work_ = 0;
    inside(n, target);
    most = std::max(most, work_);
    work_ = before + most;
  }
  void forget(std::size_t mark) {
    for (; learnt_.size() > mark; learnt_.pop_back()) registers_.erase(learnt_.back());
  }

  Register compute(const ExpressionBuilder::Data& data) {
    switch (data.kind) {
      case Kind::kConstant: return constant_register(data.value);
      case Kind::kParameter: return static_cast<Register>(data.index);
      case Kind::kLocal: return locals_.at(data.index);
      case Kind::kGroup: return node(data.inputs[0]);
      case Kind::kUnary: return push(Program::op_of(static_cast<UnaryOp>(data.detail)), data.detail, node(data.inputs[0]));
      case Kind::kBinary: return binary(data);
      case Kind::kSelect: return select(data);
      case Kind::kSum: return repeat(data, BinaryOp::kAdd, 0);
      case Kind::kProduct: return repeat(data, BinaryOp::kMultiply, 1);
      case Kind::kCall: return call(data);
    }
    throw std::logic_error("unknown expression node");
  }

  Register binary(const ExpressionBuilder::Data& data) {
    const auto op = static_cast<BinaryOp>(data.detail);
    if (op == BinaryOp::kAdd) return sum(data);
    const Register a = node(data.inputs[0]);
    double c = 0;
    if (builder_.is_constant(data.inputs[1], &c)) {
      if (op == BinaryOp::kDivide) return multiply(a, constant_register(1.0 / c));
      if (op == BinaryOp::kPow && c == std::floor(c) && c >= 0 && c <= 8 && c != 1) return power(a, static_cast<int>(c));
    }
    return push(Program::op_of(op), data.detail, a, node(data.inputs[1]));
  }

  // A sum of which one part is a product that nothing else needs is one instruction.
  bool is_own_product(Node n) const {
    const auto& data = builder_.nodes_[n];
    return data.kind == Kind::kBinary && static_cast<BinaryOp>(data.detail) == BinaryOp::kMultiply && uses_[n] == 1;
  }
  Register sum(const ExpressionBuilder::Data& data) {
    Node product = data.inputs[0], other = data.inputs[1];
    if (!is_own_product(product)) std::swap(product, other);
    const std::uint8_t detail = data.detail;
    if (!is_own_product(product)) return push(Op::kAdd, detail, node(product), node(other));
    const auto& factors = builder_.nodes_[product].inputs;
    const Register a = node(factors[0]), b = node(factors[1]), rest = node(other);
    const Register target = push(Op::kMultiplyAdd, detail, a, b);
    program_.code_.back().c = rest;
    return target;
  }

  Register power(Register e, int exponent) {
    if (exponent == 0) return constant_register(1);
    const Register square = multiply(e, e);
    if (exponent == 2) return square;
    if (exponent == 3) return multiply(square, e);
    const Register fourth = multiply(square, square);
    switch (exponent) {
      case 4: return fourth;
      case 5: return multiply(fourth, e);
      case 6: return multiply(fourth, square);
      case 7: return multiply(multiply(fourth, e), square);
      default: return multiply(fourth, fourth);
    }
  }

  Register select(const ExpressionBuilder::Data& data) {
    const Register value = node(data.inputs[0]);
    const Register target = new_register();
    const double before = work_;
    double most = 0;
    const std::size_t not_negative = jump(Op::kJumpUnlessNegative, value);
    branch(data.inputs[1], target, before, most);
    const std::size_t done_negative = jump(Op::kJump);
    land(not_negative);
    if (data.inputs[2] == data.inputs[3]) {
      branch(data.inputs[3], target, before, most);
    } else {
      const std::size_t not_zero = jump(Op::kJumpUnlessZero, value);
      branch(data.inputs[2], target, before, most);
      const std::size_t done_zero = jump(Op::kJump);
      land(not_zero);
      branch(data.inputs[3], target, before, most);
      land(done_zero);
    }
    land(done_negative);
    return target;
  }

  Register repeat(const ExpressionBuilder::Data& data, BinaryOp op, double start) {
    const Register from = node(data.inputs[1]);
    const Register to = node(data.inputs[2]);
    const Register variable = new_register();
    const Register total = new_register();
    locals_[builder_.nodes_[data.inputs[0]].index] = variable;
    move(variable, from);
    move(total, constant_register(start));
    jump(Op::kEnterLoop, from, to);
    const std::size_t top = program_.code_.size();
    const std::size_t leave = jump(Op::kJumpUnlessLessEqual, variable, to);
    const std::size_t mark = learnt_.size();
    const Register term = node(data.inputs[3]);
    program_.code_.push_back({Program::op_of(op), static_cast<std::uint8_t>(op), total, total, term, 0});
    program_.code_.push_back({Op::kAdd, static_cast<std::uint8_t>(BinaryOp::kAdd), variable, variable, constant_register(1), 0});
    forget(mark);
    program_.code_.push_back({Op::kJump, 0, 0, 0, 0, static_cast<std::uint32_t>(top)});
    land(leave);
    jump(Op::kLeaveLoop);
    return total;
  }

  Register call(const ExpressionBuilder::Data& data) {
    std::vector<Register> values;
    for (const Node input : data.inputs) values.push_back(node(input));
    const auto first = static_cast<Register>(next_register_);
    for (const Register value : values) move(new_register(), value);  // arguments side by side
    // What calls much is counted with the loops.
    constexpr double kMuch = 1000;
    const double calls = 1 + builder_.callees_[data.index]->work();
    work_ += calls;
    if (calls < kMuch) return push(Op::kCall, data.detail, first, static_cast<Register>(data.index));
    const Register zero = constant_register(0);
    program_.code_[jump(Op::kEnterLoop, zero, zero)].c = static_cast<std::uint32_t>(std::min(calls, 4e9));
    const Register result = push(Op::kCall, data.detail, first, static_cast<Register>(data.index));
    jump(Op::kLeaveLoop);
    return result;
  }

  const ExpressionBuilder& builder_;
  Program program_;
  std::size_t next_register_ = 0;
  std::vector<unsigned> uses_;  // of each node as an input
  double work_ = 0;  // calls emitted so far, as Function::work() counts them
  std::unordered_map<Node, Register> registers_;
  std::vector<Node> learnt_;
  std::unordered_map<std::uint32_t, Register> locals_;
};

std::shared_ptr<const Program> ExpressionBuilder::finish(Node root, int parameter_count) const {
  return std::make_shared<const Program>(ProgramEmitter(*this, parameter_count).emit(root));
}

}  // namespace lute
