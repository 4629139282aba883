#include "parser/options/ini.hpp"

#include <boost/fusion/include/adapt_struct.hpp>
#include <boost/spirit/home/x3.hpp>

#include "parser/options/render_options.hpp"

namespace lute::ini {

struct Assignment {
  std::string keyword;
  std::string rest;
};

}  // namespace lute::ini

BOOST_FUSION_ADAPT_STRUCT(lute::ini::Assignment, keyword, rest)

namespace lute {
namespace ini {

namespace x3 = boost::spirit::x3;
using x3::char_;
using x3::eoi;
using x3::lexeme;
using x3::omit;

// Not x3::blank, x3::alpha, x3::alnum: they end the program at a byte above 127.
const auto blank = char_(" \t");
const auto identifier = x3::raw[char_("a-zA-Z_") >> *char_("a-zA-Z0-9_")];

const auto comment = omit[char_(";#") >> *char_];
const auto end = omit[*blank] >> -comment >> eoi;

const auto double_quoted = lexeme['"' >> *(char_ - '"') >> '"'];
const auto single_quoted = lexeme['\'' >> *(char_ - '\'') >> '\''];

// The rest of a line up to a comment outside of quotes, quotes kept.
const auto quoted_piece = x3::raw['"' >> *(char_ - '"') >> '"'] | x3::raw['\'' >> *(char_ - '\'') >> '\''];
const auto raw_rest = x3::rule<class RawRest, std::string>{"value"} = x3::raw[*(quoted_piece | (char_ - char_(";#")))];

const auto assignment = x3::rule<class AssignmentRule, Assignment>{"assignment"} =
    omit[*blank] >> identifier >> omit[*blank] >> '=' >> raw_rest >> -comment >> eoi;

const auto header = x3::rule<class HeaderRule, std::string>{"header"} = omit[*blank] >> '[' >> *(char_ - ']') >>
                                                                        ']' >> omit[*char_] >> eoi;

// Switches and file names. A switch keeps its quotes inside (+I"my scene.pov"); the reader takes them off.
const auto word = x3::rule<class Word, std::string>{"word"} =
    double_quoted | single_quoted | x3::raw[+(quoted_piece | (char_ - blank - char_(";#\"'")))];
const auto words = x3::rule<class WordsRule, std::vector<std::string>>{"words"} = omit[*blank] >>
                                                                                  (word % omit[+blank]) >> end;

// A value: quoted, or up to a blank, comma, comment sign or quote.
const auto bare = x3::raw[+(char_ - blank - char_(",;#\"'"))];
const auto value = x3::rule<class ValueRule, std::string>{"value"} = double_quoted | single_quoted | bare;
const auto values = x3::rule<class ValuesRule, std::vector<std::string>>{
    "values"} = omit[*blank] >> (value % (omit[*blank] >> ',' >> omit[*blank]));
// What may follow the values on the line without being part of them: another assignment or a switch.
const auto discarded = omit[*blank] >>
                       (eoi | omit[char_("+-") >> *char_] >> eoi | omit[identifier >> *blank >> '=' >> *char_] >> eoi);

std::string trimmed(std::string text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

// An unquoted text with blanks is one value, as a user who forgot the quotes means it.
std::vector<std::string> values_of(const std::string& rest) {
  std::vector<std::string> found;
  if (x3::parse(rest.begin(), rest.end(), values >> discarded, found)) return found;
  return {trimmed(rest)};
}

// Adds one line of the file; false: it is none of the forms.
bool read_line(std::string_view content, int number, std::vector<IniSection>& sections) {
  const auto matches = [&](const auto& rule, auto&... attribute) {
    return x3::parse(content.begin(), content.end(), rule, attribute...);
  };
  if (matches(end)) return true;
  if (std::string name; matches(header, name)) {
    sections.push_back({trimmed(name), {}});
    return true;
  }
  if (Assignment found; matches(assignment, found)) {
    sections.back().lines.push_back({number, found.keyword, values_of(found.rest), trimmed(found.rest)});
    return true;
  }
  if (std::vector<std::string> found; matches(words, found)) {
    sections.back().lines.push_back({number, {}, std::move(found), {}});
    return true;
  }
  return false;
}

}  // namespace ini

std::vector<IniSection> parse_ini(std::string_view text, std::string_view file_name) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<IniSection> sections(1);
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view content = text.substr(begin, end - begin);
    if (!content.empty() && content.back() == '\r') content.remove_suffix(1);
    begin = end + 1;
    ++number;
    if (content.find('\0') != std::string_view::npos) {
      throw OptionError(std::string(file_name) + ":" + std::to_string(number) + ": a NUL byte: this is no plain text");
    }
    if (!ini::read_line(content, number, sections)) {
      throw OptionError(std::string(file_name) + ":" + std::to_string(number) +
                        ": neither 'Keyword = value', a [section], a switch, a file name nor a comment");
    }
  }
  return sections;
}

}  // namespace lute
