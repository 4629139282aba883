#include "parser/diagnostic/block_advice.hpp"

#include <utility>

#include "parser/diagnostic/statement_form.hpp"
#include "parser/directives/macro.hpp"
#include "parser/expression/expression.hpp"
#include "parser/session.hpp"

namespace lute {

namespace {

// Between the keyword of the block and the mistake stand numbers and vectors only.
bool is_head(const SourceFile& file, const Token* keyword, const SourceLocation& mistake) {
  constexpr int kLongestHead = 100;
  const Token* const end = file.tokens.data() + file.tokens.size();
  for (const Token* token = keyword + 1; token < end && token < keyword + kLongestHead; ++token) {
    const SourceLocation where = file.locate(token->offset);
    if (std::pair(where.line, where.column) >= std::pair(mistake.line, mistake.column)) return true;
    Item item;
    item.token = *token;
    if (token->kind == TokenKind::kWord && !starts_number(item)) return false;
  }
  return false;
}

}  // namespace

std::string form_of_block(const Session& session, const Diagnostic& d) {
  const std::string_view message = d.message;
  const bool about_value = message.starts_with("Expected 'numeric expression'") || message.starts_with("Float expected") ||
                           message.starts_with("Vector expected") ||
                           (message.starts_with("No matching } in") && message.ends_with(",  found instead"));
  if (session.open_blocks.empty() || !about_value || message.find("undeclared identifier") != std::string_view::npos ||
      message.ends_with(", ) found instead")) return "";
  const OpenBlock& block = session.open_blocks.back();
  if (block.keyword == nullptr || block.keyword->kind != TokenKind::kWord || block.file != d.where.file) return "";
  const std::string_view form = statement_form(spelling(block.keyword->word));
  if (form.empty() || !is_head(*session.files[block.file], block.keyword, d.where)) return "";
  const std::string_view what = message.starts_with("Float expected")    ? "a number belongs here: "
                                : message.starts_with("Vector expected") ? "a vector <x, y, z> belongs here: "
                                                                         : "written as ";
  return std::string(what) + std::string(form);
}

namespace {

constexpr int kFarthest = 500;  // tokens: what is longer is no expression

// The innermost `(` that is open in front of the token, or null.
const Token* open_parenthesis(const SourceFile& file, const Token* token) {
  int closed = 0;
  const Token* const first = file.tokens.data() + file.kept_from;
  for (int i = 0; i < kFarthest && token > first; ++i) {
    --token;
    if (token->kind == TokenKind::kRightParen) ++closed;
    if (token->kind == TokenKind::kLeftParen && closed-- == 0) return token;
  }
  return nullptr;
}

// Behind the token stands the `)` of a parenthesis that is open there, as far as the expression may reach.
bool is_closed_behind(const SourceFile& file, const Token* token) {
  const bool in_list = token->kind == TokenKind::kComma;
  int parentheses = 0, vectors = 0;
  const Token* const end = file.tokens.data() + file.tokens.size();
  for (int i = 0; i < kFarthest && token < end; ++i, ++token) {
    switch (token->kind) {
      case TokenKind::kLeftParen: ++parentheses; break;
      case TokenKind::kRightParen:
        if (parentheses-- == 0) return true;
        break;
      case TokenKind::kLess: ++vectors; break;
      case TokenKind::kGreater:
        if (vectors-- == 0 && in_list) return false;
        break;
      case TokenKind::kLeftBrace: case TokenKind::kRightBrace: case TokenKind::kSemicolon: case TokenKind::kHash:
      case TokenKind::kEnd: case TokenKind::kMore: case TokenKind::kError: return false;
      default: break;
    }
  }
  return false;
}

// "Foo(A, B)" if the token is the name of a macro with these parameters, else "".
std::string call_of_macro(Session& session, const Token& token) {
  if (token.kind != TokenKind::kName) return "";
  const Value* const value = session.symbols.find_value(token.index);
  const MacroPtr* const macro = value == nullptr ? nullptr : value->get_if<MacroPtr>();
  if (macro == nullptr) return "";
  std::string call = std::string(session.names.text(token.index)) + "(";
  for (const NameId parameter : (*macro)->parameters) {
    if (call.back() != '(') call += ", ";
    call += session.names.text(parameter);
  }
  return call + ")";
}

}  // namespace

std::string about_parenthesis(Session& session, std::string_view expected, const Item& found) {
  const SourceFile& file = *session.files[found.file];
  const Token* const first = file.tokens.data() + file.kept_from;
  if (found.source == nullptr || found.source <= first || found.source >= file.tokens.data() + file.tokens.size()) return "";
  if (expected == "(") {
    const std::string call = call_of_macro(session, found.source[-1]);
    return call.empty() ? "" : "the macro is called as " + call;
  }
  if (expected != ")") return "";
  const Token* const open = open_parenthesis(file, found.source);
  if (open == nullptr) return "";
  if (!is_closed_behind(file, found.source)) {
    const SourceLocation where = file.locate(open->offset);
    return "the ( at " + std::to_string(where.line) + ":" + std::to_string(where.column) + " is not closed";
  }
  const TokenKind before = open == first ? TokenKind::kComma : open[-1].kind;
  const bool is_call = before == TokenKind::kName || before == TokenKind::kWord;
  if (!found.is(TokenKind::kComma)) return "";
  return is_call ? "these are more arguments than there may be, or a ) is missing in front of the comma" : "a vector is written <x, y, z>";
}

}  // namespace lute
