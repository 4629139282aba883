// Numbers: specification chapter 10 §1 and its check cases 19 and 20.
#include <gtest/gtest.h>

#include <chrono>

#include "parser/lexer/source_file.hpp"
#include "tests/parser/read_text.hpp"

namespace lute {
namespace {

Tokens tokens_of(std::string text) {
  Names names;
  SourceFile file;
  file.set_text(FileText(std::move(text)));
  lex(file, names, true);
  return file.tokens;
}

double number(const std::string& text) {
  const auto tokens = tokens_of(text);
  EXPECT_EQ(tokens.front().kind, TokenKind::kNumber) << text;
  return tokens.front().number;
}

std::string first_error(std::string text) {
  Names names;
  SourceFile file;
  file.set_text(FileText(std::move(text)));
  lex(file, names, true);
  return file.errors.empty() ? "" : file.errors.front();
}

TEST(Words, AreAllOfTheChapterOnce) {
  EXPECT_EQ(kWordCount, 499);
  EXPECT_EQ(find_word("light_source"), Word::kLightSource);
  EXPECT_EQ(find_word("Sphere"), std::nullopt);
  EXPECT_EQ(spelling(Word::kPiWord), "pi");
  EXPECT_EQ(canonical(Word::kColourMap), Word::kColorMap);
}

TEST(Lexer, ReadsNumbersAsStrtodDoes) {
  EXPECT_EQ(number("5."), 5);
  EXPECT_EQ(number(".5"), .5);
  EXPECT_EQ(number("1e"), 1);
  EXPECT_EQ(number("1e+"), 1);
  EXPECT_EQ(number("1e23"), 1e23);
  EXPECT_EQ(number("1e-25"), 1e-25);
  EXPECT_EQ(number("0.1234567890123456789"), 0.1234567890123456789);
  EXPECT_EQ(number("1e400"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(number("1e-400"), 0);
}

TEST(Lexer, TakesTheLongestOperator) {
  const auto tokens = tokens_of("<1,2>=<=!=!>");
  std::vector<TokenKind> kinds;
  for (const Token& token : tokens) kinds.push_back(token.kind);
  EXPECT_EQ(kinds, (std::vector<TokenKind>{TokenKind::kLess, TokenKind::kNumber, TokenKind::kComma, TokenKind::kNumber,
                                           TokenKind::kGreaterEqual, TokenKind::kLessEqual, TokenKind::kNotEqual,
                                           TokenKind::kExclamation, TokenKind::kGreater, TokenKind::kEnd}));
}

TEST(Lexer, NestsBlockComments) {
  EXPECT_EQ(tokens_of("/* a /* b */ \" */ x").size(), 2u);
  EXPECT_EQ(first_error("/* /* */"), "No */ closing comment found.");
  EXPECT_EQ(tokens_of("1 // \"x\n2").size(), 3u);
}

TEST(Lexer, RefusesWhatTheReferenceRefuses) {
  EXPECT_EQ(first_error("\"" + std::string(256, 'a') + "\""), "String too long.");
  EXPECT_EQ(first_error("\"" + std::string(255, 'a') + "\""), "");
  EXPECT_EQ(first_error(std::string(256, 'a')), "String too long.");
  EXPECT_EQ(first_error("\"abc"), "No end quote for string.");
  EXPECT_EQ(first_error("\"abc\\\n\""), "Unterminated string literal.");
  EXPECT_EQ(first_error("a \xe9"), "Illegal character in input file, value is e9.");
  EXPECT_EQ(first_error("1.2.3"), "Unexpected additional '.' in floating-point number");
}

TEST(Lexer, SkipsAByteOrderMark) {
  const auto tokens = tokens_of("\xef\xbb\xbfsphere");
  EXPECT_EQ(tokens.front().word, Word::kSphere);
  EXPECT_EQ(tokens.front().offset, 3u);
}

TEST(Lexer, EveryLineEndIsOneLine) {
  SourceFile file;
  file.set_text(FileText("a\nb\r\nc\rd\n\re"));
  EXPECT_EQ(file.locate(2).line, 2u);
  EXPECT_EQ(file.locate(5).line, 3u);
  EXPECT_EQ(file.locate(7).line, 4u);
  EXPECT_EQ(file.locate(10).line, 5u);
  EXPECT_EQ(file.locate(10).column, 1u);
  EXPECT_EQ(file.line(3), "c");
}

// A big binary file given by mistake: the first illegal byte ends it, whatever its size.
TEST(Lexer, GivesUpOnBinaryAtOnce) {
  std::string text(100'000'000, '\xff');
  text[0] = 'a';
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(tokens_of(std::move(text)).size(), 3u);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

TEST(DumpTokens, ShowsOneTokenALine) {
  EXPECT_EQ(dump_tokens("a.pov", "sphere { a, 1.5 \"t\" }"),
            "1:1 word sphere\n1:8 {\n1:10 name a\n1:11 , \n1:13 number 1.5\n1:17 string \"t\"\n1:21 }\n1:22 end\n");
}

}  // namespace
}  // namespace lute
