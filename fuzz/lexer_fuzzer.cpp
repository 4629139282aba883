// libFuzzer target: any bytes through the lexer alone. In a large file runs of literals are one token until they are read, which may
// show nowhere, and neither may the pieces in which it is lexed: the bytes are also lexed as the end of one.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "parser/lexer/source_file.hpp"

namespace {

constexpr std::size_t kLarge = 1u << 20;  // bytes of a file in which runs are looked for
constexpr std::size_t kRun = 8192;        // more than the least bytes of a run
constexpr std::size_t kMostErrors = 1000;

lute::Tokens tokens_of(const std::string& text, bool in_pieces) {
  lute::Names names;
  lute::SourceFile file;
  file.set_text(lute::FileText(text));
  if (in_pieces) {
    lute::begin_lexing(file, names, true);
    while (!file.complete()) lute::lex_more(file, names);
  } else {
    lute::lex(file, names, true);
  }
  lute::Tokens all, piece;
  for (const lute::Token& token : file.tokens) {
    if (token.kind != lute::TokenKind::kRun) {
      all.push_back(token);
      continue;
    }
    const lute::LiteralRun& run = file.runs[token.index];
    for (std::uint32_t position = run.begin; position < run.end;) {
      lute::lex_run(file, names, run, position, piece);
      all.insert(all.end(), piece.begin(), piece.end() - 1);  // without its kEnd
    }
  }
  if (file.errors.size() >= kMostErrors) return {};  // reading ended somewhere
  for (const lute::Token& token : all) {
    if (lute::token_end(file, token) > text.size()) std::abort();
    file.locate(token.offset);
  }
  return all;
}

void expect_same(const lute::Tokens& a, const lute::Tokens& b) {
  if (a.size() != b.size()) std::abort();
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].kind != b[i].kind || a[i].offset != b[i].offset) std::abort();
    if (a[i].kind == lute::TokenKind::kNumber && a[i].number != b[i].number) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  tokens_of(text, false);
  // A megabyte in every execution would be slow: only for inputs that begin with two digits.
  if (size < 2 || data[0] < '0' || data[0] > '9' || data[1] < '0' || data[1] > '9') return 0;
  std::string large(kLarge, '\n');
  while (large.size() < kLarge + kRun) large += text;
  expect_same(tokens_of(large, false), tokens_of(large, true));
  return 0;
}
