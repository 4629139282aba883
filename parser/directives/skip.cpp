// Skipping of regions that are not executed. The text was tokenised already, so strings and comments are honoured; nested
// conditionals, loops and macro definitions are counted. Where a region ends is remembered: loops skip the same regions again.
#include "parser/directives/directive.hpp"
#include "parser/directives/directive_words.hpp"

namespace lute {

namespace {

bool stops(Word word, bool to_end) { return word == Word::kEnd || (!to_end && selects_branch(word)); }

}  // namespace

Word skip(Session& session, bool to_end, const Token* macro) {
  TokenStream& stream = session.stream;
  SourceFile* const start_file = stream.frames.back().file;
  const std::uint32_t key = start_file->token_index(stream.frames.back().cursor) * 2 + (to_end ? 1u : 0u);
  const std::size_t start_depth = stream.frames.size();
  ++stream.events;
  if (const auto known = start_file->skip_targets.find(key); known != start_file->skip_targets.end()) {
    const Token* const word = start_file->tokens.data() + known->second;
    stream.frames.back().cursor = word + 1;
    return word->word;
  }
  for (std::size_t depth = 0;;) {
    TokenFrame& frame = stream.frames.back();
    const Token& token = *frame.cursor;
    if (token.kind == TokenKind::kMore) {
      stream.read_ahead(1);
      continue;
    }
    if (frame.cursor == frame.end || token.kind == TokenKind::kError) {
      // A conditional may end in the file that includes this one; a macro's body is complete in itself.
      if (frame.macro || stream.frames.size() == 1 || token.kind == TokenKind::kError) {
        Item item;
        item.token = token;
        item.file = frame.file->index;
        item.source = frame.cursor;
        if (token.kind == TokenKind::kError) session.fail_at(frame.file->errors[token.index], "unreadable-text", item);
        session.fail_missing_end(item, macro);
      }
      stream.frames.pop_back();
      session.symbols.pop_table();
      continue;
    }
    ++frame.cursor;
    if (token.kind != TokenKind::kHash || frame.cursor == frame.end || frame.cursor->kind != TokenKind::kWord) continue;
    const Word word = frame.cursor->word;
    if (depth == 0 && stops(word, to_end)) {
      if (stream.frames.size() == start_depth) start_file->skip_targets[key] = start_file->token_index(frame.cursor);
      ++frame.cursor;
      return word;
    }
    if (opens_region(word)) ++depth;
    if (word == Word::kEnd) --depth;
  }
}

}  // namespace lute
