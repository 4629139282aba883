// Code of expressions in which every value is a float, as most are in loops: a stack of doubles, names resolved to where their
// values live until a name is added or removed anywhere.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "parser/value/value.hpp"

namespace lute {

struct Code;
struct Session;

enum class ScalarOp : std::uint8_t {
  kConstant,      // index: constant
  kLoad,          // index: name
  kLoadMember,    // index: name of a vector, count: component
  kElement,       // index: name of an array, count: subscripts
  kAdd, kSubtract, kMultiply,
  kBinary,        // count: TokenKind
  kNegate, kNot,
  kCall,          // index: Word of a float function, count: arguments
  kUserFunction,  // index: name, count: arguments
  kChoose         // condition, then, else
};

struct ScalarInstruction {
  ScalarOp op = ScalarOp::kConstant;
  std::uint16_t count = 0;
  std::uint32_t index = 0;
};

struct ScalarCode {
  std::vector<ScalarInstruction> instructions;
  std::vector<double> constants;
  std::vector<NameId> names;
  std::vector<Value*> values;    // of the names, while `generation` is the symbol table's
  std::uint64_t generation = 0;  // 0: not resolved
};

// Null if the expression needs more than floats.
std::unique_ptr<ScalarCode> scalar_code(const Code& code);

// False, and nothing has happened, if a name does not hold what the code needs.
bool run_scalar(Session& session, ScalarCode& code, double& result);

}  // namespace lute
