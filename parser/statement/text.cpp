#include "parser/statement/text.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "engine/shape/glyph_outline.hpp"
#include "parser/session.hpp"
#include "parser/statement/state.hpp"

namespace lute {
namespace {

// The built-in fonts are files of the standard library too.
std::string name_of_internal_font(int number) {
  switch (number) {
    case 1: return "timrom.ttf";
    case 2: return "cyrvetic.ttf";
    case 3: return "crystal.ttf";
    default: return "povlogo.ttf";
  }
}

std::string parse_font_name(Reader& reader) {
  if (reader.accept(Word::kTtf)) return reader.file_name();
  if (reader.accept(Word::kInternal)) return name_of_internal_font(reader.integer());
  reader.error_expected("ttf or internal");
}

struct FontName {
  std::string text;
  SourceLocation where;
};

// POV-Ray opens the font when it has read what follows, and tells that place; the note tells where the name stands.
[[noreturn]] void fail_font(Reader& reader, const FontName& name, std::string_view code, const std::string& message) {
  Session& session = reader.session();
  const Item& next = reader.peek();
  Diagnostic d = session.diagnose(Severity::kError, std::string(code), message, next.file, next.source);
  d.chain.insert(d.chain.begin(), {"'" + name.text + "' is named at", session.files[name.where.file]->name, name.where});
  session.report_fatal(std::move(d));
}

std::shared_ptr<const std::string> load_font(Reader& reader, const FontName& name) {
  const auto path = reader.find_file(name.text, {".ttf", ".TTF"});
  if (!path) fail_font(reader, name, "missing-file", "Cannot open font file.");
  std::shared_ptr<const std::string>& font = statements_of(reader).fonts[*path];
  if (font == nullptr) {
    std::ifstream file(*path, std::ios::binary);
    if (!file) fail_font(reader, name, "missing-file", "Cannot open font file.");
    auto read = std::make_shared<const std::string>(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    try {
      check_font(*read);
    } catch (const std::runtime_error& error) {
      fail_font(reader, name, "bad-file", error.what());
    }
    font = std::move(read);
  }
  return font;
}

}  // namespace

Text parse_text(Reader& reader) {
  Text text;
  FontName font;
  font.text = parse_font_name(reader);
  font.where = reader.location();
  reader.comma();
  text.string = reader.string();
  reader.comma();
  text.depth = reader.number();
  reader.comma();
  text.offset = reader.vector();
  text.font = load_font(reader, font);
  text.unicode_first = reader.session().language.charset != Reader::Charset::kAscii;
  return text;
}

}  // namespace lute
