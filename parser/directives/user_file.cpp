// #fopen #fclose #read #write. Source: specification chapter 10 §6.5.
#include "parser/directives/user_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "parser/directives/directive.hpp"
#include "parser/expression/expression.hpp"
#include "parser/value/array.hpp"

namespace lute {

namespace {

// For writing or appending. Behind an error a scene writes nothing more: the file stays closed and takes what is written.
void open_for_output(Session& session, UserFile& file, const std::string& name, std::ios::openmode mode) {
  if (session.recovery.any()) return;
  if (!session.permissions.may_write(name)) {
    Diagnostic d = session.diagnose(Severity::kError, "io-restriction", "IO restrictions prohibit write access to '" + name + "'.",
                                    session.stream.last_file, session.stream.last_token);
    d.hint = "--allow-write FOLDER permits it";
    session.report_fatal(std::move(d));
  }
  session.prepare_writing(name);
  file.output.open(name, std::ios::binary | mode);
  if (file.output) return;
  session.fail("Cannot open user file " + name + (mode == std::ios::app ? " (append)." : " (write)."), "user-file");
}

UserFilePtr take_open_file(Session& session) {
  const Item name = session.stream.take_raw();
  const UserFilePtr* file = name.slot ? name.slot->get_if<UserFilePtr>() : nullptr;
  if (file == nullptr) session.fail_expected("file identifier", name);
  return *file;
}

void open_for_reading(Session& session, UserFile& file, const std::string& name) {
  const auto path = find_scene_file(session, name, {});
  std::error_code error;
  const std::uintmax_t size = path ? std::filesystem::file_size(*path, error) : 0;
  std::optional<FileText> text;
  if (path && !error) text = FileText::of_file(*path, size);
  if (!text) session.fail("Cannot open user file " + name + " (read).", "user-file");
  file.input.name = *path;
  session.resources.charge(size);
  file.input.set_text(std::move(*text));
  file.input.keep_text();
  file.reading = true;
  lex(file.input, session.names, false);
  file.cursor = file.input.tokens.data();
}

}  // namespace

void run_fopen(Session& session) {
  TokenStream& stream = session.stream;
  const Item id = stream.take_raw();
  if (!id.is(TokenKind::kName)) session.fail_expected("undeclared identifier", id);
  const std::string name = to_bytes(session, parse_string(session, true));
  const Item mode = stream.take_raw();
  auto file = std::make_shared<UserFile>();
  file->name = name;
  switch (mode.word()) {
    case Word::kRead: open_for_reading(session, *file, name); break;
    case Word::kWrite: open_for_output(session, *file, name, std::ios::trunc); break;
    case Word::kAppend: open_for_output(session, *file, name, std::ios::app); break;
    default: session.fail_expected("read or write", mode);
  }
  session.symbols.add(id.token.index, 0, std::make_shared<Value>(UserFilePtr(std::move(file))));
}

void run_fclose(Session& session) {
  const Item id = session.stream.take_raw();
  if (id.slot && id.slot->holds<UserFilePtr>()) {
    session.symbols.remove(id.token.index);
  }  // anything else is no open file, and no mistake
}

namespace {

[[noreturn]] void fail_data(Session& session, const UserFile& file, const char* expected) {
  const SourceLocation where = file.input.locate(file.cursor->offset);
  std::string found(name_of(file.cursor->kind));
  if (file.cursor->kind == TokenKind::kWord) found = spelling(file.cursor->word);
  if (file.cursor->kind == TokenKind::kName) found += " '" + std::string(session.names.text(file.cursor->index)) + "'";
  if (file.cursor->kind == TokenKind::kError) session.fail(file.input.errors[file.cursor->index], "user-file");
  session.fail("Expected '" + std::string(expected) + "', " + found + " found instead (in file '" + file.input.name + "', line " +
                   std::to_string(where.line) + ")",
               "user-file");
}

double read_signed_number(Session& session, UserFile& file) {
  double sign = 1;
  while (file.cursor->kind == TokenKind::kMinus || file.cursor->kind == TokenKind::kPlus) {
    if (file.cursor->kind == TokenKind::kMinus) sign = -sign;
    ++file.cursor;
  }
  if (file.cursor->kind != TokenKind::kNumber) fail_data(session, file, "float, vector, or string literal");
  return sign * (file.cursor++)->number;
}

void skip_comma(UserFile& file) {
  if (file.cursor->kind == TokenKind::kComma) ++file.cursor;
}

Value read_item(Session& session, UserFile& file) {
  switch (file.cursor->kind) {
    case TokenKind::kString:
      return std::make_shared<const std::u16string>(decode_literal(session, file.input.strings[(file.cursor++)->index], true));
    case TokenKind::kLess: {
      ++file.cursor;
      Number number;
      number.count = 0;
      while (file.cursor->kind != TokenKind::kGreater) {
        if (number.count == 5) fail_data(session, file, ">");
        number.c[static_cast<std::size_t>(number.count++)] = read_signed_number(session, file);
        skip_comma(file);
      }
      ++file.cursor;
      if (number.count < 2) fail_data(session, file, "float, vector, or string literal");
      return number;
    }
    default: return Number(read_signed_number(session, file));
  }
}

// Where a #read item goes: a new global name, or a variable (or element that has a value) of a type that can be read.
Slot read_target(Session& session) {
  TokenStream& stream = session.stream;
  const Item name = stream.take_raw();
  if (name.is(TokenKind::kName)) {
    return session.symbols.add(name.token.index, 0, std::make_shared<Value>()).slot;
  }
  if (!name.is(TokenKind::kIdentifier)) session.fail_expected("undeclared identifier", name);
  const WrittenElement element = written_element(session, name);
  const Slot slot = element.array ? ArrayElements::reference(element.array, element.index) : name.slot;
  const Number* number = slot->get_if<Number>();
  const bool readable = slot->holds<String>() || (number != nullptr && (number->count == 1 || number->count == 3));
  if (!readable) {
    Item found = name;
    found.slot = slot;
    session.fail_expected("undeclared identifier", found);
  }
  return slot;
}

}  // namespace

void run_read(Session& session) {
  TokenStream& stream = session.stream;
  open_paren(session);
  const NameId id = stream.peek_raw().token.index;
  const UserFilePtr file = take_open_file(session);
  if (!file->reading) session.fail("Cannot read from file " + file->name + " because the file is open for writing only.", "user-file");
  bool at_end = false;
  for (;;) {
    if (stream.peek_raw().is(TokenKind::kComma)) stream.take_raw();
    if (stream.peek_raw().is(TokenKind::kRightParen)) break;
    const Slot target = read_target(session);
    if (file->cursor->kind == TokenKind::kEnd) at_end = true;
    if (at_end) continue;  // the variable keeps its value
    assign(session, *target, read_item(session, *file));
    // A string without its closing quote is an item in front of the error.
    if (file->cursor->kind == TokenKind::kError) fail_data(session, *file, ",");
    // Without a comma behind the item the next token is read and lost: that is how the reference looks for the comma.
    if (file->cursor->kind == TokenKind::kEnd) {
      at_end = true;
    } else {
      ++file->cursor;
    }
  }
  close_paren(session);
  if (at_end) session.symbols.remove(id);
}

namespace {

struct IntegerFormat {
  double low, high;
  int bytes;
  bool big_endian;
};

std::optional<IntegerFormat> integer_format(Word word) {
  switch (word) {
    case Word::kUint8: return IntegerFormat{0, 255, 1, false};
    case Word::kSint8: return IntegerFormat{-128, 127, 1, false};
    case Word::kUint16be: return IntegerFormat{0, 65535, 2, true};
    case Word::kUint16le: return IntegerFormat{0, 65535, 2, false};
    case Word::kSint16be: return IntegerFormat{-32768, 32767, 2, true};
    case Word::kSint16le: return IntegerFormat{-32768, 32767, 2, false};
    case Word::kSint32be: return IntegerFormat{-2147483648.0, 2147483647.0, 4, true};
    case Word::kSint32le: return IntegerFormat{-2147483648.0, 2147483647.0, 4, false};
    default: return std::nullopt;
  }
}

void write_integer(std::ofstream& out, double value, const IntegerFormat& format) {
  const double rounded = std::isnan(value) ? 0 : std::min(std::max(std::floor(value + 0.5), format.low), format.high);
  const auto bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(rounded));
  for (int i = 0; i < format.bytes; ++i) {
    const int shift = 8 * (format.big_endian ? format.bytes - 1 - i : i);
    out.put(static_cast<char>(static_cast<unsigned char>(bits >> shift & 0xFF)));
  }
}

void write_number(std::ofstream& out, const Number& value) {
  std::array<char, 40> text{};
  const auto print = [&](double v) {
    std::snprintf(text.data(), text.size(), "%g", v);
    out << text.data();
  };
  if (value.is_float()) return print(value.c[0]);
  out << '<';
  for (int i = 0; i < value.count; ++i) {
    if (i > 0) out << ',';
    print(value.c[static_cast<std::size_t>(i)]);
  }
  out << "> ";
}

}  // namespace

void run_write(Session& session) {
  Reader& reader = session.reader;
  open_paren(session);
  const UserFilePtr file = take_open_file(session);
  if (file->reading) session.fail("Cannot write to file " + file->name + " because the file is open for reading only.", "user-file");
  if (session.recovery.any()) file->output.setstate(std::ios::badbit);  // a scene with an error writes nothing more
  for (;;) {
    reader.comma();
    const Item& next = reader.peek();
    if (next.is(TokenKind::kRightParen)) break;
    if (const auto format = integer_format(next.word())) {
      reader.take();
      while (reader.at_number()) {
        const Number value = evaluate(session, Level::kAdditive);
        for (int i = 0; i < value.count; ++i) write_integer(file->output, value.c[static_cast<std::size_t>(i)], *format);
      }
      if (reader.at_string()) session.fail_expected("expression", reader.peek());
      continue;
    }
    const bool color = next.is(TokenKind::kIdentifier) && next.slot->holds<Number>() && next.slot->get_if<Number>()->count == 5;
    if (color || (!starts_number(next) && !starts_string(next))) session.fail_expected("string", next);
    if (starts_string(next)) {
      file->output << to_bytes(session, parse_string(session));
    } else {
      write_number(file->output, evaluate(session, Level::kAdditive));
    }
  }
  close_paren(session);
  file->output.flush();
  if (!file->output && !session.recovery.any()) session.fail("Cannot write to file " + file->name + ".", "user-file");
}

}  // namespace lute
