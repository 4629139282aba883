#include "parser/lexer/source_file.hpp"

#include <algorithm>
#include <functional>

namespace lute {

Names::Names() : buckets_(4096, kFree) {
  for (int i = 0; i < static_cast<int>(Word::kWordListEnd); ++i) intern(spelling(static_cast<Word>(i)));
}

NameId Names::intern(std::string_view name) {
  const std::size_t mask = buckets_.size() - 1;
  std::size_t slot = std::hash<std::string_view>{}(name) & mask;
  for (; buckets_[slot] != kFree; slot = (slot + 1) & mask) {
    if (texts_[buckets_[slot]] == name) return buckets_[slot];
  }
  const auto id = static_cast<NameId>(texts_.size());
  texts_.emplace_back(name);
  buckets_[slot] = id;
  if (texts_.size() * 2 > buckets_.size()) grow();
  return id;
}

void Names::grow() {
  std::vector<NameId> bigger(buckets_.size() * 4, kFree);
  const std::size_t mask = bigger.size() - 1;
  for (NameId id = 0; id < texts_.size(); ++id) {
    std::size_t slot = std::hash<std::string_view>{}(texts_[id]) & mask;
    while (bigger[slot] != kFree) slot = (slot + 1) & mask;
    bigger[slot] = id;
  }
  buckets_ = std::move(bigger);
}

namespace {

constexpr std::uint32_t kMarkDistance = 128;
constexpr std::size_t kReleased = 16u << 20;  // memory of a mapped file that was passed is given back in pieces of this size
constexpr std::uint32_t kAnyOffset = 0xFFFFFFFF, kAnyLine = 0xFFFFFFFF;

// The line end at `i`: LF, CR, CRLF and LFCR each end one line. 0: there is none, else its length.
std::uint32_t line_end(std::string_view text, std::uint32_t i) {
  const char c = text[i];
  if (c != '\n' && c != '\r') return 0;
  const bool pair = i + 1 < text.size() && (text[i + 1] == '\n' || text[i + 1] == '\r') && text[i + 1] != c;
  return pair ? 2 : 1;
}

}  // namespace

// Counts lines up to `to`, or to the line end that it lies within.
void SourceFile::count_lines(LineMark& here, std::uint32_t to) const {
  const char* const data = text.data();
  for (;;) {
    std::uint32_t at = here.offset;
    while (at < to && static_cast<unsigned char>(data[at]) > '\r') ++at;
    here.offset = at;
    if (at >= to) return;
    const std::uint32_t length = line_end(text, here.offset);
    if (here.offset + length > to) return;
    here.offset += length == 0 ? 1 : length;
    if (length == 0) continue;
    ++here.line;
    here.line_start = here.offset;
  }
}

// Until this offset or this line is passed.
void SourceFile::find_lines(std::uint32_t to_offset, std::uint32_t to_line) const {
  const auto size = static_cast<std::uint32_t>(text.size());
  while (counted_.offset < size && counted_.offset <= to_offset && counted_.line <= to_line) {
    count_lines(counted_, size - counted_.offset < kMarkDistance ? size : counted_.offset + kMarkDistance);
    line_marks_.push_back(counted_);
    if (counted_.offset - released_ >= kReleased) {
      storage.release(released_, counted_.offset);
      released_ = counted_.offset;
    }
  }
}

void SourceFile::forget_tokens(const Token* before) {
  const std::uint32_t to = token_index(before);
  if (to <= kept_from) return;
  ReservedPages<Token>::give_back(tokens.data() + kept_from, tokens.data() + to, tokens.capacity());
  kept_from = to;
  forgotten = true;
}

SourceLocation SourceFile::locate(std::uint32_t offset) const {
  find_lines(offset, kAnyLine);
  // Places are mostly asked for in the order of the text: then the last one is nearer than any mark.
  if (offset < located_.offset || offset - located_.offset > kMarkDistance) {
    located_ = *(std::ranges::upper_bound(line_marks_, offset, {}, &LineMark::offset) - 1);
  }
  count_lines(located_, std::min(offset, static_cast<std::uint32_t>(text.size())));
  return {index, located_.line, offset - located_.line_start + 1};
}

std::string_view SourceFile::line(std::uint32_t number, std::size_t most) const {
  if (number == 0) return {};
  find_lines(kAnyOffset, number);
  // From the last mark that lies in an earlier line, or from the beginning.
  const auto after = std::ranges::lower_bound(line_marks_, number, {}, &LineMark::line);
  LineMark here = after == line_marks_.begin() ? LineMark{} : *(after - 1);
  for (std::uint32_t i = here.offset; here.line < number;) {
    if (i >= text.size()) return {};
    const std::uint32_t length = line_end(text, i);
    i += length == 0 ? 1 : length;
    if (length == 0) continue;
    ++here.line;
    here.line_start = i;
  }
  const std::string_view rest = text.substr(here.line_start, most);
  return rest.substr(0, rest.find_first_of("\r\n"));
}

std::uint32_t token_end(const SourceFile& file, const Token& token) {
  const std::string_view rest = file.text.substr(std::min<std::size_t>(token.offset, file.text.size()));
  const auto is_name = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  std::size_t length = rest.empty() ? 0 : 1;
  switch (token.kind) {
    case TokenKind::kNumber:
      while (length < rest.size() && (is_name(rest[length]) || rest[length] == '.' ||
                                      ((rest[length] == '+' || rest[length] == '-') && (rest[length - 1] | 32) == 'e'))) {
        ++length;
      }
      break;
    case TokenKind::kName:
    case TokenKind::kWord:
    case TokenKind::kIdentifier:
      while (length < rest.size() && is_name(rest[length])) ++length;
      break;
    case TokenKind::kString:
      while (length < rest.size() && rest[length] != '"' && rest[length] != '\n') length += rest[length] == '\\' ? 2 : 1;
      length = std::min(length + 1, rest.size());
      break;
    case TokenKind::kLessEqual:
    case TokenKind::kGreaterEqual:
    case TokenKind::kNotEqual: length = 2; break;
    default: break;
  }
  return token.offset + static_cast<std::uint32_t>(length);
}

}  // namespace lute
