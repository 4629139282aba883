// What happens when an error was found: it is reported, and reading goes on at the next statement, so that one run tells every
// mistake. Errors that only follow from an earlier one are not told: names whose declaration failed, the same place met again in
// a loop or macro, a `}` left over. Behind the first error nothing is printed or written any more, and loops that were open do
// not turn again.
#pragma once

#include <cstdint>
#include <set>
#include <tuple>
#include <unordered_set>

#include "parser/diagnostic/diagnostic.hpp"
#include "parser/lexer/source_file.hpp"

namespace lute {

struct Session;

class Recovery {
 public:
  explicit Recovery(Session& session) : session_(session) {}

  // The innermost frame's next token begins a statement or a directive between statements.
  void begin_statement(std::size_t frames, std::size_t conditionals, const Token* token) {
    frames_ = frames;
    conditionals_ = conditionals;
    start_ = token;
  }
  // An error was found at this token (null: nowhere).
  void set_place(std::uint32_t file, const Token* token) {
    error_file_ = file;
    error_ = token;
  }

  // A file was not included: any name may be declared there.
  void miss_include() { include_missing_ = true; }

  bool any() const { return errors_ > 0; }
  // False once reading behind an error takes too long: what the scene does then is no longer what its author meant.
  bool within_budget() const;

  // Reports the error, unless it only follows from another, and moves to the next statement. False: there is none.
  bool recover(const SceneError& error);

 private:
  bool report(const Diagnostic& diagnostic);
  bool follows_from_another(const Diagnostic& diagnostic) const;
  void unwind();
  bool begins_statement(const Token& token) const;
  bool move_on();
  void note_assignments(const Token* from, const Token* to);

  Session& session_;
  std::size_t frames_ = 0, conditionals_ = 0;
  const Token* start_ = nullptr;
  std::uint32_t error_file_ = 0;
  const Token* error_ = nullptr;

  std::size_t errors_ = 0;
  std::size_t untold_ = 0;  // that only followed from others
  std::uint64_t first_error_events_ = 0;
  const Token* resumed_at_ = nullptr;
  bool lost_ = false;                // the rest of a file was left out: its #end is missing for that reason
  bool include_missing_ = false;     // any name may have been declared there
  std::unordered_set<NameId> names_;  // whose declarations could not be read
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> told_;  // places: file, line, column
};

}  // namespace lute
