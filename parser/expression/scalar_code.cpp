#include "parser/expression/scalar_code.hpp"

#include <algorithm>
#include <optional>

#include "parser/expression/expression.hpp"
#include "parser/session.hpp"
#include "parser/value/array.hpp"

namespace lute {

namespace {

constexpr std::size_t kMostValues = 64;  // on the stack

// All arguments and the result are floats.
bool is_float_function(Word word) {
  const std::string_view signature = numeric_signature(word);
  return !signature.empty() && signature.find('V') == std::string_view::npos;
}

class Translator {
 public:
  explicit Translator(const Code& code) : source_(code), code_(std::make_unique<ScalarCode>()) {}

  std::unique_ptr<ScalarCode> run() {
    if (draws_and_selects()) return nullptr;
    for (std::size_t i = 0; i < source_.instructions.size(); ++i) {
      const bool member = i + 1 < source_.instructions.size() && source_.instructions[i + 1].op == CodeOp::kMember;
      if (source_.instructions[i].op == CodeOp::kLoad && member) {
        if (!load_member(source_.instructions[i], source_.instructions[i + 1])) return nullptr;
        ++i;
      } else if (!translate(source_.instructions[i])) {
        return nullptr;
      }
      if (depth_ > kMostValues) return nullptr;
    }
    return std::move(code_);
  }

 private:
  // An element that turns out to be no float sends the expression back to the parser: nothing may have happened before.
  bool draws_and_selects() const {
    bool draws = false, selects = false;
    for (const CodeInstruction& i : source_.instructions) {
      draws |= i.op == CodeOp::kCall && (i.index == static_cast<std::uint32_t>(Word::kRand) ||
                                         i.index == static_cast<std::uint32_t>(Word::kSeed));
      selects |= i.op == CodeOp::kElement;
    }
    return draws && selects;
  }

  bool emit(ScalarOp op, std::size_t taken, std::size_t count = 0, std::uint32_t index = 0) {
    code_->instructions.push_back({op, static_cast<std::uint16_t>(count), index});
    depth_ = depth_ - taken + 1;
    return true;
  }

  std::uint32_t name(NameId id) {
    const auto found = std::ranges::find(code_->names, id);
    if (found != code_->names.end()) return static_cast<std::uint32_t>(found - code_->names.begin());
    code_->names.push_back(id);
    return static_cast<std::uint32_t>(code_->names.size() - 1);
  }

  bool load_member(const CodeInstruction& load, const CodeInstruction& member) {
    if (static_cast<Member>(member.detail) == Member::kGray) return false;
    return emit(ScalarOp::kLoadMember, 0, member.detail, name(load.index));
  }

  bool translate(const CodeInstruction& i) {
    switch (i.op) {
      case CodeOp::kConstant: {
        const Number& value = source_.constants[i.index];
        if (!value.is_float()) return false;
        code_->constants.push_back(value.c[0]);
        return emit(ScalarOp::kConstant, 0, 0, static_cast<std::uint32_t>(code_->constants.size() - 1));
      }
      case CodeOp::kLoad: return emit(ScalarOp::kLoad, 0, 0, name(i.index));
      case CodeOp::kElement: return emit(ScalarOp::kElement, i.count, i.count, name(i.index));
      case CodeOp::kBinary: return binary(static_cast<TokenKind>(i.detail));
      case CodeOp::kNegate: return emit(ScalarOp::kNegate, 1);
      case CodeOp::kNot: return emit(ScalarOp::kNot, 1);
      case CodeOp::kCall: return is_float_function(static_cast<Word>(i.index)) && emit(ScalarOp::kCall, i.count, i.count, i.index);
      case CodeOp::kUserFunction: return emit(ScalarOp::kUserFunction, i.count, i.count, name(i.index));
      case CodeOp::kChoose: return emit(ScalarOp::kChoose, 3);
      default: return false;
    }
  }

  bool binary(TokenKind op) {
    switch (op) {
      case TokenKind::kPlus: return emit(ScalarOp::kAdd, 2);
      case TokenKind::kMinus: return emit(ScalarOp::kSubtract, 2);
      case TokenKind::kStar: return emit(ScalarOp::kMultiply, 2);
      default: return emit(ScalarOp::kBinary, 2, static_cast<std::size_t>(op));
    }
  }

  const Code& source_;
  std::unique_ptr<ScalarCode> code_;
  std::size_t depth_ = 0;
};

bool resolve(Session& session, ScalarCode& code) {
  code.values.resize(code.names.size());
  for (std::size_t i = 0; i < code.names.size(); ++i) {
    const SymbolTable::Entry* const entry = session.symbols.find(code.names[i]);
    if (entry == nullptr || entry->deprecation) return false;
    code.values[i] = entry->slot.get();
  }
  code.generation = session.symbols.generation();
  return true;
}

// Every name holds what its instruction needs.
bool fits(const ScalarCode& code) {
  for (const ScalarInstruction& i : code.instructions) {
    switch (i.op) {
      case ScalarOp::kLoad: {
        const Number* const number = code.values[i.index]->get_if<Number>();
        if (number == nullptr || !number->is_float()) return false;
        break;
      }
      case ScalarOp::kLoadMember: {
        const Number* const number = code.values[i.index]->get_if<Number>();
        if (number == nullptr || i.count >= number->count) return false;
        break;
      }
      case ScalarOp::kElement: {
        const ArrayPtr* const array = code.values[i.index]->get_if<ArrayPtr>();
        if (array == nullptr || (*array)->sizes.size() != i.count) return false;
        break;
      }
      case ScalarOp::kUserFunction: {
        const FunctionPtr* const function = code.values[i.index]->get_if<FunctionPtr>();
        if (function == nullptr || (*function)->parameter_count() != i.count || (*function)->result_count() != 1) return false;
        break;
      }
      default: break;
    }
  }
  return true;
}

std::optional<double> element(const ScalarCode& code, const ScalarInstruction& i, const double* subscripts) {
  const Array& array = **code.values[i.index]->get_if<ArrayPtr>();
  std::size_t index = 0;
  for (std::size_t k = 0; k < i.count; ++k) {
    const double subscript = subscripts[k] + kEpsilon;
    if (!(subscript >= 0 && subscript < array.sizes[k])) return std::nullopt;
    index = index * static_cast<std::size_t>(array.sizes[k]) + static_cast<std::size_t>(subscript);
  }
  double value = 0;
  return array.elements.get_float(index, value) ? std::optional(value) : std::nullopt;
}

double binary(Session& session, TokenKind op, double left, double right) {
  switch (op) {
    case TokenKind::kSlash:
      if (right != 0) return left / right;
      break;
    case TokenKind::kLess: return left < right ? 1 : 0;
    case TokenKind::kGreater: return left > right ? 1 : 0;
    default: break;
  }
  return apply_binary(session, op, Number(left), Number(right)).c[0];
}

}  // namespace

std::unique_ptr<ScalarCode> scalar_code(const Code& code) { return Translator(code).run(); }

bool run_scalar(Session& session, ScalarCode& code, double& result) {
  if (code.generation != session.symbols.generation() && !resolve(session, code)) return false;
  if (!fits(code)) return false;
  double stack[kMostValues];
  double* top = stack;  // behind the last value
  for (const ScalarInstruction& i : code.instructions) {
    switch (i.op) {
      case ScalarOp::kConstant: *top++ = code.constants[i.index]; break;
      case ScalarOp::kLoad: *top++ = code.values[i.index]->get_if<Number>()->c[0]; break;
      case ScalarOp::kLoadMember: *top++ = code.values[i.index]->get_if<Number>()->c[i.count]; break;
      case ScalarOp::kElement: {
        top -= i.count;
        const std::optional<double> value = element(code, i, top);
        if (!value) return false;
        *top++ = *value;
        break;
      }
      case ScalarOp::kAdd: --top; top[-1] += *top; break;
      case ScalarOp::kSubtract: --top; top[-1] -= *top; break;
      case ScalarOp::kMultiply: --top; top[-1] *= *top; break;
      case ScalarOp::kBinary: --top; top[-1] = binary(session, static_cast<TokenKind>(i.count), top[-1], *top); break;
      case ScalarOp::kNegate: top[-1] = -top[-1]; break;
      case ScalarOp::kNot: top[-1] = is_true(top[-1]) ? 0 : 1; break;
      case ScalarOp::kCall:
        top -= i.count;
        *top = apply_float_function(session, static_cast<Word>(i.index), {top, i.count});
        ++top;
        break;
      case ScalarOp::kUserFunction: {
        top -= i.count;
        double value = 0;
        (*code.values[i.index]->get_if<FunctionPtr>())->evaluate(top, &value);
        *top++ = value;
        break;
      }
      case ScalarOp::kChoose: top -= 2; top[-1] = is_true(top[-1]) ? top[0] : top[1]; break;
    }
  }
  result = top[-1];
  return true;
}

}  // namespace lute
