// Between the grammar and the code it records; and the operands that are written as plain functions.
#pragma once

#include "parser/expression/expression.hpp"
#include "parser/session.hpp"

namespace lute {

inline void record(Session& session, CodeInstruction instruction) {
  if (session.expressions.recording) session.expressions.recording->instructions.push_back(instruction);
}
inline void record_constant(Session& session, const Number& value) {
  if (!session.expressions.recording) return;
  Code& code = *session.expressions.recording;
  code.constants.push_back(value);
  record(session, {CodeOp::kConstant, 0, 0, static_cast<std::uint32_t>(code.constants.size() - 1)});
}
inline void record_binary(Session& session, TokenKind op) {
  record(session, {CodeOp::kBinary, static_cast<std::uint8_t>(op), 0, 0});
}
// This expression holds something that code cannot do.
inline void stop_recording(Session& session) { session.expressions.recording.reset(); }

// Starts recording if the tokens may be read again and begin at the frame's cursor.
bool begin_recording(Session& session);
void end_recording(Session& session, Level level);
// Runs what was recorded for the tokens at the frame's cursor. False: nothing there, or it does not fit any more.
bool run_compiled(Session& session, Level level, Number& result);

// Operands. Each records itself or stops the recording.
bool parse_word_operand(Session& session, Word word, Number& result);               // constants and built-in functions
bool parse_call_of_value(Session& session, const Item& item, Number& result);       // splines and user functions; item was taken
bool parse_string_comparison(Session& session, Number& result);

// `( argument`, `, argument`, `)` of a call.
void open_call(Session& session);
void close_call(Session& session);
double float_argument(Session& session, Level level);
dvec3 vector_argument(Session& session);

}  // namespace lute
