// Expressions as stack code: made while an expression in a loop or macro is parsed for the first time, run instead of parsing
// whenever its tokens come again. Only what depends on nothing but values of names is compiled; everything else is parsed.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "parser/directives/known_directive.hpp"
#include "parser/expression/scalar_code.hpp"
#include "parser/lexer/token.hpp"
#include "parser/value/value.hpp"

namespace lute {

struct Session;
struct SourceFile;

enum class Level : std::uint8_t { kAdditive, kFull };  // how much of the grammar is allowed (specification chapter 10 §7.1)
constexpr int kFirstVersionWithOperators = 150;        // times 100: below it an additive expression is a single factor

enum class CodeOp : std::uint8_t {
  kConstant,      // index: constant
  kLoad,          // index: name (a float, vector or colour)
  kElement,       // index: name of an array, count: subscripts
  kBinary,        // detail: TokenKind of the operator
  kNegate, kNot,
  kMember,        // detail: Member
  kVector,        // count: components
  kCall,          // index: Word of the function, count: arguments
  kUserFunction,  // index: name, count: arguments
  kSpline,        // index: name, detail: 1 + SplineKind, or 0 for the spline's own
  kChoose,        // condition, then, else
  kVersion,       // the language version
  kDimensionSize  // index: name of an array; argument: the dimension
};

struct CodeInstruction {
  CodeOp op = CodeOp::kConstant;
  std::uint8_t detail = 0;
  std::uint16_t count = 0;
  std::uint32_t index = 0;
};

struct Code {
  std::vector<CodeInstruction> instructions;
  std::vector<Number> constants;
  const Token* begin = nullptr;
  const Token* end = nullptr;  // the first token behind the expression
  Level level = Level::kAdditive;
  std::unique_ptr<ScalarCode> scalar;  // null: not all values are floats
  std::uint32_t next = 0;      // another level's code for the same tokens, 0: none
};

struct ExpressionState {
  std::deque<Code> codes{1};    // codes[0] is unused
  std::deque<KnownDirective> directives{1};  // the same
  std::vector<Number> stack;    // of the running code
  std::unique_ptr<Code> recording;  // what is being recorded; null while nothing is
  bool nested = false;          // inside an expression: arguments and subscripts belong to it
  std::size_t depth = 0;        // of nested parentheses, calls and signs

  // A directive or macro call in the middle of an expression: what it evaluates is not part of that expression, and an
  // expression that was interrupted is not compiled.
  class Interruption {
   public:
    explicit Interruption(ExpressionState& state) : state_(state), nested_(state.nested), depth_(state.depth) {
      state.recording.reset();
      state.nested = false;
    }
    ~Interruption() {
      state_.recording.reset();
      state_.nested = nested_;
      state_.depth = depth_;
    }
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

   private:
    ExpressionState& state_;
    bool nested_;
    std::size_t depth_;
  };
};

// After #version has changed what the same tokens mean: they are parsed anew.
void forget_compiled(Session& session);

// Runs a code if every name in it still holds what it needs; else false, and nothing has happened.
bool run(Session& session, const Code& code, Number& result);

}  // namespace lute
