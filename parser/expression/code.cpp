#include "parser/expression/code.hpp"

#include "parser/diagnostic/advice.hpp"
#include "parser/expression/recorder.hpp"
#include "parser/value/array.hpp"

namespace lute {

bool begin_recording(Session& session) {
  TokenStream& stream = session.stream;
  ExpressionState& state = session.expressions;
  state.recording.reset();
  if (!stream.repeats() || !stream.window_empty()) return false;
  const TokenFrame& frame = stream.frames.back();
  if (frame.in_run() || frame.cursor == frame.end || frame.cursor->kind == TokenKind::kHash) return false;
  if (frame.cursor->kind == TokenKind::kRun) return false;
  state.recording = std::make_unique<Code>();
  state.recording->begin = frame.cursor;
  return true;
}

void end_recording(Session& session, Level level) {
  TokenStream& stream = session.stream;
  ExpressionState& state = session.expressions;
  // The token behind the expression has been fetched; its own subscripts were recorded if it is an array element.
  const Item& next = stream.peek();
  if (next.subscripts > 0 || next.token.kind == TokenKind::kEnd) return;
  SourceFile& file = *stream.frames.back().file;
  Code& code = *state.recording;
  if (stream.frames.back().in_run() || next.file != file.index || next.source <= code.begin) return;
  code.end = next.source;
  code.level = level;
  if (file.expression_codes.size() < file.tokens.size()) file.expression_codes.resize(file.tokens.size());
  code.scalar = scalar_code(code);
  std::uint32_t& entry = file.expression_codes[file.token_index(code.begin)];
  code.next = entry;
  entry = static_cast<std::uint32_t>(state.codes.size());
  state.codes.push_back(std::move(code));
}

void forget_compiled(Session& session) {
  for (const std::unique_ptr<SourceFile>& file : session.files) file->expression_codes.clear();
}

bool run_compiled(Session& session, Level level, Number& result) {
  TokenStream& stream = session.stream;
  if (!stream.repeats() || !stream.window_empty()) return false;
  TokenFrame& frame = stream.frames.back();
  SourceFile& file = *frame.file;
  if (file.expression_codes.empty() || frame.in_run() || frame.cursor == frame.end) return false;
  std::uint32_t index = file.code_at(frame.cursor);
  while (index != 0 && session.expressions.codes[index].level != level) index = session.expressions.codes[index].next;
  if (index == 0) return false;
  const Code& code = session.expressions.codes[index];
  // A name behind the expression may have become a macro, whose body could go on with it.
  if (code.end->kind == TokenKind::kName) {
    const Value* value = session.symbols.find_value(code.end->index);
    if (value != nullptr && value->holds<MacroPtr>()) return false;
  }
  stream.last_file = file.index;
  stream.last_token = code.begin;
  double value = 0;
  if (code.scalar && run_scalar(session, *code.scalar, value)) {
    result = Number(value);
  } else if (!run(session, code, result)) {
    return false;
  }
  frame.cursor = code.end;
  stream.last_token = code.end - 1;
  return true;
}

namespace {

// Every name of the code still holds what its instruction needs.
bool fits(Session& session, const Code& code) {
  for (const CodeInstruction& instruction : code.instructions) {
    switch (instruction.op) {
      case CodeOp::kLoad: {
        const SymbolTable::Entry* entry = session.symbols.find(instruction.index);
        if (entry == nullptr || entry->deprecation || !entry->slot->holds<Number>()) return false;
        break;
      }
      case CodeOp::kElement: {
        const Value* value = session.symbols.find_value(instruction.index);
        const ArrayPtr* array = value != nullptr ? value->get_if<ArrayPtr>() : nullptr;
        if (array == nullptr || (*array)->sizes.size() != instruction.count) return false;
        break;
      }
      case CodeOp::kDimensionSize: {
        const Value* value = session.symbols.find_value(instruction.index);
        if (value == nullptr || !value->holds<ArrayPtr>()) return false;
        break;
      }
      case CodeOp::kUserFunction: {
        const Value* value = session.symbols.find_value(instruction.index);
        const FunctionPtr* function = value != nullptr ? value->get_if<FunctionPtr>() : nullptr;
        if (function == nullptr || (*function)->parameter_count() != instruction.count) return false;
        break;
      }
      case CodeOp::kSpline: {
        const Value* value = session.symbols.find_value(instruction.index);
        if (value == nullptr || !value->holds<SplinePtr>()) return false;
        break;
      }
      default: break;
    }
  }
  return true;
}

std::size_t element_index(Session& session, const Array& array, const Number* subscripts) {
  std::size_t index = 0;
  for (std::size_t i = 0; i < array.sizes.size(); ++i) {
    const double subscript = promoted(session, subscripts[i], 1).c[0] + kEpsilon;
    if (subscript < 0) session.fail("Negative subscript", "subscript");
    if (!(subscript < array.sizes[i])) {
      session.fail("Array subscript out of range", "subscript",
                   index_advice("the elements", static_cast<std::size_t>(array.sizes[i]), subscript));
    }
    index = index * static_cast<std::size_t>(array.sizes[i]) + static_cast<std::size_t>(subscript);
  }
  return index;
}

// The code's stack machine.
class Machine {
 public:
  Machine(Session& session, const Code& code) : session_(session), code_(code), stack_(session.expressions.stack) {}

  // False if an element of an array does not hold a number: then the expression has to be parsed.
  bool run(Number& result) {
    const std::size_t base = stack_.size();
    for (const CodeInstruction& instruction : code_.instructions) {
      if (!step(instruction)) {
        stack_.resize(base);
        return false;
      }
    }
    result = stack_.back();
    stack_.resize(base);
    return true;
  }

 private:
  bool step(const CodeInstruction& i) {
    switch (i.op) {
      case CodeOp::kConstant: stack_.push_back(code_.constants[i.index]); break;
      case CodeOp::kLoad: stack_.push_back(*session_.symbols.find_value(i.index)->get_if<Number>()); break;
      case CodeOp::kElement: return element(i);
      case CodeOp::kBinary: binary(static_cast<TokenKind>(i.detail)); break;
      case CodeOp::kNegate: stack_.back() = apply_negate(stack_.back()); break;
      case CodeOp::kNot: stack_.back() = apply_not(stack_.back()); break;
      case CodeOp::kMember: stack_.back() = apply_member(session_, stack_.back(), static_cast<Member>(i.detail)); break;
      case CodeOp::kVector: vector(i.count); break;
      case CodeOp::kCall: {
        const std::size_t first = stack_.size() - i.count;
        const Number value = apply_function(session_, static_cast<Word>(i.index), std::span<const Number>(stack_).subspan(first));
        replace(first, value);
        break;
      }
      case CodeOp::kUserFunction: user_function(i); break;
      case CodeOp::kSpline: spline(i); break;
      case CodeOp::kChoose: choose(); break;
      case CodeOp::kVersion: stack_.push_back(Number(session_.language.version / 100.0)); break;
      case CodeOp::kDimensionSize: dimension_size(i); break;
    }
    return true;
  }

  void replace(std::size_t first, const Number& value) {
    stack_.resize(first);
    stack_.push_back(value);
  }

  void binary(TokenKind op) {
    const Number right = stack_.back();
    stack_.pop_back();
    Number& left = stack_.back();
    if (left.count == 1 && right.count == 1) {  // the common case, without the loops over components
      switch (op) {
        case TokenKind::kPlus: left.c[0] += right.c[0]; return;
        case TokenKind::kMinus: left.c[0] -= right.c[0]; return;
        case TokenKind::kStar: left.c[0] *= right.c[0]; return;
        default: break;
      }
    }
    left = apply_binary(session_, op, left, right);
  }

  bool element(const CodeInstruction& i) {
    const Array& array = **session_.symbols.find_value(i.index)->get_if<ArrayPtr>();
    const std::size_t first = stack_.size() - i.count;
    const std::size_t index = element_index(session_, array, stack_.data() + first);
    stack_.resize(first + 1);
    if (array.elements.get_number(index, stack_.back())) return true;
    if (!array.elements.has_value(index)) session_.fail("Attempt to access uninitialized array element.", "uninitialized");
    return false;
  }

  void vector(std::uint16_t count) {
    Number result;
    result.count = count;
    const std::size_t first = stack_.size() - count;
    for (std::size_t k = 0; k < count; ++k) result.c[k] = promoted(session_, stack_[first + k], 1).c[0];
    replace(first, result);
  }

  void user_function(const CodeInstruction& i) {
    const FunctionPtr& function = *session_.symbols.find_value(i.index)->get_if<FunctionPtr>();
    const std::size_t first = stack_.size() - i.count;
    std::array<double, 64> arguments{};
    for (std::size_t k = 0; k < i.count; ++k) arguments[k] = promoted(session_, stack_[first + k], 1).c[0];
    Number result;
    result.count = function->result_count();
    function->evaluate(arguments.data(), result.c.data());
    replace(first, result);
  }

  void spline(const CodeInstruction& i) {
    const SplinePtr& spline = *session_.symbols.find_value(i.index)->get_if<SplinePtr>();
    const double t = promoted(session_, stack_.back(), 1).c[0];
    Number result;
    result.count = spline->components;
    result.c = i.detail == 0 ? spline->evaluate(t) : spline->evaluate(t, static_cast<SplineKind>(i.detail - 1));
    stack_.back() = result;
  }

  void choose() {
    const std::size_t first = stack_.size() - 3;
    if (!stack_[first].is_float()) session_.fail("Conditional must evaluate to a float.", "float-expected");
    replace(first, is_true(stack_[first].c[0]) ? Number(stack_[first + 1]) : Number(stack_[first + 2]));
  }

  void dimension_size(const CodeInstruction& i) {
    const Array& array = **session_.symbols.find_value(i.index)->get_if<ArrayPtr>();
    const std::int32_t dimension = to_int32(promoted(session_, stack_.back(), 1).c[0]);
    const bool exists = dimension >= 1 && static_cast<std::size_t>(dimension) <= array.sizes.size();
    stack_.back() = Number(exists ? array.sizes[static_cast<std::size_t>(dimension - 1)] : 0);
  }

  Session& session_;
  const Code& code_;
  std::vector<Number>& stack_;
};

}  // namespace

bool run(Session& session, const Code& code, Number& result) {
  return fits(session, code) && Machine(session, code).run(result);
}

}  // namespace lute
