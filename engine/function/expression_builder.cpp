#include <bit>
#include <cmath>

#include "engine/function/program.hpp"

namespace lute {
namespace {

// Precedence levels whose chains fold neighbouring constants: + -, comparisons, & and | each on its own.
int chain_level(BinaryOp op) {
  switch (op) {
    case BinaryOp::kAdd:
    case BinaryOp::kSubtract: return 1;
    case BinaryOp::kMultiply:
    case BinaryOp::kDivide: return 2;
    case BinaryOp::kLess:
    case BinaryOp::kLessEqual:
    case BinaryOp::kEqual:
    case BinaryOp::kNotEqual:
    case BinaryOp::kGreaterEqual:
    case BinaryOp::kGreater: return 3;
    case BinaryOp::kAnd: return 4;
    case BinaryOp::kOr: return 5;
    default: return 0;
  }
}

}  // namespace

ExpressionBuilder::Node ExpressionBuilder::add(Data data) {
  if (data.kind != Kind::kParameter && data.kind != Kind::kCall)
    for (const Node input : data.inputs) data.has_parameter = data.has_parameter || nodes_[input].has_parameter;
  if (data.kind == Kind::kCall)  // a call counts only through its arguments
    for (const Node input : data.inputs) data.has_parameter = data.has_parameter || nodes_[input].has_parameter;
  const auto key = std::tuple(data.kind, data.detail, data.index, std::bit_cast<std::uint64_t>(data.value), data.inputs);
  if (const auto it = known_.find(key); it != known_.end()) return it->second;
  nodes_.push_back(std::move(data));
  const Node node = static_cast<Node>(nodes_.size() - 1);
  known_.emplace(key, node);
  return node;
}

ExpressionBuilder::Node ExpressionBuilder::constant(double value) {
  return add({.kind = Kind::kConstant, .value = value, .inputs = {}});
}

// A constant that was computed from others.
ExpressionBuilder::Node ExpressionBuilder::folded(double value) {
  return add({.kind = Kind::kConstant, .detail = 1, .value = value, .inputs = {}});
}

ExpressionBuilder::Node ExpressionBuilder::parameter(unsigned index) {
  return add({.kind = Kind::kParameter, .index = index, .inputs = {}, .has_parameter = true});
}

ExpressionBuilder::Node ExpressionBuilder::local() {
  return add({.kind = Kind::kLocal, .index = local_count_++, .inputs = {}, .has_parameter = true});
}

bool ExpressionBuilder::is_constant(Node a, double* value) const {
  const Data* data = &nodes_[a];
  while (data->kind == Kind::kGroup) data = &nodes_[data->inputs[0]];
  if (data->kind != Kind::kConstant) return false;
  if (value != nullptr) *value = data->value;
  return true;
}

ExpressionBuilder::Node ExpressionBuilder::unary(UnaryOp op, Node a) {
  double value = 0;
  if (is_constant(a, &value)) return folded(apply(op, value));
  return add({.kind = Kind::kUnary, .detail = static_cast<std::uint8_t>(op), .inputs = {a}});
}

ExpressionBuilder::Node ExpressionBuilder::binary(BinaryOp op, Node a, Node b) {
  double right = 0;
  const bool right_constant = is_constant(b, &right);
  // Only a 0 that is written so, under something that varies: `1/0` and `x/(1-1)` are infinite.
  const bool written_zero = right_constant && right == 0 && nodes_[b].kind == Kind::kConstant && nodes_[b].detail == 0;
  if (op == BinaryOp::kDivide && written_zero && !is_constant(a, nullptr)) throw ConstantDomainError{"Division by zero."};
  if (op == BinaryOp::kSubtract && right_constant) return binary(BinaryOp::kAdd, a, constant(-right));
  double left = 0;
  if (right_constant && is_constant(a, &left)) return folded(apply(op, left, right));

  // (X op1 c1) op2 c2 becomes X op1 (c1 op2 c2): the reference folds neighbouring constants whatever stands to their left. For * and /
  // it does so only where no parameter stands there.
  const Data& chain = nodes_[a];
  if (right_constant && chain.kind == Kind::kBinary && chain_level(op) != 0) {
    const auto inner = static_cast<BinaryOp>(chain.detail);
    double middle = 0;
    if (chain_level(inner) == chain_level(op) && is_constant(chain.inputs[1], &middle) &&
        (chain_level(op) != 2 || !chain.has_parameter)) {
      const Node rest = chain.inputs[0];
      return binary(inner, rest, folded(apply(op, middle, right)));
    }
  }
  return add({.kind = Kind::kBinary, .detail = static_cast<std::uint8_t>(op), .inputs = {a, b}});
}

ExpressionBuilder::Node ExpressionBuilder::group(Node a) {
  if (nodes_[a].kind != Kind::kBinary) return a;
  return add({.kind = Kind::kGroup, .inputs = {a}});
}

ExpressionBuilder::Node ExpressionBuilder::select(Node value, Node negative, Node zero, Node positive) {
  double v = 0;
  if (is_constant(value, &v)) return v < 0 ? negative : v == 0 ? zero : positive;
  return add({.kind = Kind::kSelect, .inputs = {value, negative, zero, positive}});
}

ExpressionBuilder::Node ExpressionBuilder::repeat(bool product, Node local, Node from, Node to, Node term) {
  return add({.kind = product ? Kind::kProduct : Kind::kSum, .inputs = {local, from, to, term}});
}

ExpressionBuilder::Node ExpressionBuilder::call(FunctionPtr function, std::span<const Node> arguments, unsigned component) {
  std::uint32_t callee = 0;
  while (callee < callees_.size() && callees_[callee] != function) ++callee;
  if (callee == callees_.size()) callees_.push_back(std::move(function));
  return add({.kind = Kind::kCall,
              .detail = static_cast<std::uint8_t>(component),
              .index = callee,
              .inputs = {arguments.begin(), arguments.end()}});
}

}  // namespace lute
