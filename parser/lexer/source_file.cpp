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

void SourceFile::find_lines() const {
  // LF, CR, CRLF and LFCR each end one line.
  line_starts_.push_back(0);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c != '\n' && c != '\r') continue;
    if (i + 1 < text.size() && (text[i + 1] == '\n' || text[i + 1] == '\r') && text[i + 1] != c) ++i;
    line_starts_.push_back(static_cast<std::uint32_t>(i + 1));
  }
}

SourceLocation SourceFile::locate(std::uint32_t offset) const {
  if (line_starts_.empty()) find_lines();
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  const auto line = static_cast<std::uint32_t>(after - line_starts_.begin());
  return {index, line, offset - *(after - 1) + 1};
}

std::string_view SourceFile::line(std::uint32_t number) const {
  if (line_starts_.empty()) find_lines();
  if (number == 0 || number > line_starts_.size()) return {};
  const std::string_view rest = std::string_view(text).substr(line_starts_[number - 1]);
  return rest.substr(0, rest.find_first_of("\r\n"));
}

std::uint32_t token_end(const SourceFile& file, const Token& token) {
  const std::string_view rest = std::string_view(file.text).substr(std::min<std::size_t>(token.offset, file.text.size()));
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
