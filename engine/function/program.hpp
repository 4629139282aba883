// `function { expression }` compiled: register code for one expression, common subexpressions computed once, constants folded as
// the reference folds them (specification chapters 10 §11.3 and 21 §11.2).
//
//   ExpressionBuilder e;
//   auto x = e.parameter(0);
//   auto program = e.finish(e.binary(BinaryOp::kAdd, x, e.constant(1)), 1);   // x + 1
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "engine/function/function.hpp"

namespace lute {

enum class UnaryOp : std::uint8_t {
  kNegate, kSin, kCos, kTan, kAsin, kAcos, kAtan, kSinh, kCosh, kTanh, kAsinh, kAcosh, kAtanh,
  kAbs, kRadians, kDegrees, kFloor, kCeil, kInt, kSqrt, kExp, kLn, kLog
};
enum class BinaryOp : std::uint8_t {
  kAdd, kSubtract, kMultiply, kDivide, kLess, kLessEqual, kEqual, kNotEqual, kGreaterEqual, kGreater, kAnd, kOr,
  kAtan2, kMod, kPow, kDiv, kMin, kMax
};

// What the operators compute, for the folding of constants and for anyone who evaluates without a program.
double apply(UnaryOp op, double a);
double apply(BinaryOp op, double a, double b);

// The loops of sum() and prod(), one inside the other, would turn more often than this, or functions call each other as often: a
// mistake, not a value.
constexpr double kMostTurns = 1e9;
class EndlessFunction : public std::range_error {
 public:
  static EndlessFunction loops() { return EndlessFunction("sum() or prod() of a function turns more than 1000000000 times."); }
  static EndlessFunction calls() { return EndlessFunction("Functions call each other more than 1000000000 times."); }

 private:
  using std::range_error::range_error;
};

// evaluate() throws EndlessFunction. evaluate_many() runs each instruction over a block of points (program_block.cpp).
class Program final : public Function {
 public:
  void evaluate(const double* arguments, double* results) const override;
  void evaluate_many(std::size_t count, std::size_t stride, const double* arguments, double* results) const override;
  bool enclose(const Enclosure* arguments, Enclosure* results) const override;

  std::size_t instruction_count() const { return code_.size() - 1; }  // without the return

 private:
  friend class ProgramEmitter;
  explicit Program(int parameters) : Function(parameters, 1) {}
  enum class Op : std::uint8_t {
    kUnary, kBinary,
    kAdd, kSubtract, kMultiply, kNegate, kAbs, kSqrt, kSin, kCos,  // the commonest of these, each with `detail` as those have
    kMultiplyAdd,  // a b + c, rounded twice
    kMove, kCall, kJump, kJumpUnlessNegative, kJumpUnlessZero, kJumpUnlessLessEqual,
    kEnterLoop,  // from a to b
    kLeaveLoop,
    kReturn  // the last one, and only that
  };
  struct Instruction {
    Op op;
    std::uint8_t detail = 0;          // UnaryOp, BinaryOp, or the component of a call's result
    std::uint16_t target = 0;         // register
    std::uint16_t a = 0, b = 0;       // registers; of a call: first argument, callee
    std::uint32_t c = 0;              // a jump's instruction; a third register; the calls of one turn of a loop
  };

  class Enclosing;
  class Block;
  static Op op_of(UnaryOp op);
  static Op op_of(BinaryOp op);

  // Registers: parameters, then constants, then temporaries; the result is in result_.
  std::vector<double> constants_;
  std::size_t register_count_ = 0;
  std::vector<Instruction> code_;
  std::vector<FunctionPtr> callees_;
  std::uint16_t result_ = 0;
};

// A mistake that the language reports when it folds constants ("Division by zero.").
struct ConstantDomainError {
  std::string message;
};

// Builds the expression bottom-up. Equal subexpressions become one node.
class ExpressionBuilder {
 public:
  using Node = std::uint32_t;

  Node constant(double value);
  Node parameter(unsigned index);
  Node local();  // the running variable of a sum or prod; a new one each time

  Node unary(UnaryOp op, Node a);
  // Folds neighbouring constants of one precedence level as the reference does, also where that changes the meaning
  // (`a < 3 = 1` is `a < (3 = 1)`). Throws ConstantDomainError for a division of what varies
  // by a 0 that is written as such.
  Node binary(BinaryOp op, Node a, Node b);
  Node group(Node a);  // a parenthesised expression: no folding across its border
  Node select(Node value, Node negative, Node zero, Node positive);  // three arguments: pass `zero` twice
  Node sum(Node local, Node from, Node to, Node term) { return repeat(false, local, from, to, term); }
  Node product(Node local, Node from, Node to, Node factor) { return repeat(true, local, from, to, factor); }
  Node call(FunctionPtr function, std::span<const Node> arguments, unsigned component = 0);

  bool is_constant(Node a, double* value = nullptr) const;

  std::shared_ptr<const Program> finish(Node root, int parameter_count) const;

 private:
  friend class ProgramEmitter;
  enum class Kind : std::uint8_t { kConstant, kParameter, kLocal, kUnary, kBinary, kGroup, kSelect, kSum, kProduct, kCall };
  struct Data {
    Kind kind;
    std::uint8_t detail = 0;         // operator, component; of a constant 1 if it was computed
    std::uint32_t index = 0;         // parameter, local, callee
    double value = 0;                // constant
    std::vector<Node> inputs;
    bool has_parameter = false;      // contains a parameter (a call with constant arguments does not count)
  };

  Node add(Data data);
  Node folded(double value);
  Node repeat(bool product, Node local, Node from, Node to, Node term);

  std::vector<Data> nodes_;
  std::vector<FunctionPtr> callees_;
  std::uint32_t local_count_ = 0;
  std::map<std::tuple<Kind, std::uint8_t, std::uint32_t, std::uint64_t, std::vector<Node>>, Node> known_;
};

}  // namespace lute
