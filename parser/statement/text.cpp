#include "parser/statement/text.hpp"

#include <fstream>
#include <iterator>

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

std::shared_ptr<const std::string> load_font(Reader& reader, const std::string& name) {
  const auto path = reader.find_file(name, {".ttf", ".TTF"});
  if (!path) reader.error("Cannot open font file.", "missing-file");
  std::shared_ptr<const std::string>& font = statements_of(reader).fonts[*path];
  if (font == nullptr) {
    std::ifstream file(*path, std::ios::binary);
    if (!file) reader.error("Cannot open font file.", "missing-file");
    font = std::make_shared<const std::string>(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return font;
}

}  // namespace

Text parse_text(Reader& reader) {
  Text text;
  text.font = load_font(reader, parse_font_name(reader));
  reader.comma();
  text.string = reader.string();
  reader.comma();
  text.depth = reader.number();
  reader.comma();
  text.offset = reader.vector();
  text.unicode_first = reader.session().language.charset != Reader::Charset::kAscii;
  return text;
}

}  // namespace lute
