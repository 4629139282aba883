#include "compare/page_section.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace lute::compare {

namespace {

struct Place {
  std::size_t begin, end;  // of the text between the marks
};

Place place_of(const std::string& page, const std::string& name) {
  const std::string begin = "<!-- lute-compare " + name + ": begin -->\n", end = "<!-- lute-compare " + name + ": end -->\n";
  const std::size_t from = page.find(begin);
  const std::size_t to = page.find(end, from == std::string::npos ? 0 : from);
  if (from == std::string::npos || to == std::string::npos) {
    throw std::runtime_error("the page has no lines '" + begin.substr(0, begin.size() - 1) + "' and '" +
                             end.substr(0, end.size() - 1) + "'");
  }
  return {from + begin.size(), to};
}

}  // namespace

std::string section_of(const std::string& page, const std::string& name) {
  const Place place = place_of(page, name);
  return page.substr(place.begin, place.end - place.begin);
}

std::string with_section(const std::string& page, const std::string& name, const std::string& section) {
  const Place place = place_of(page, name);
  return page.substr(0, place.begin) + section + page.substr(place.end);
}

void replace_section(const std::filesystem::path& file, const std::string& name, const std::string& section) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  const std::string page(std::istreambuf_iterator<char>(in), {});
  const std::string changed = with_section(page, name, section);
  std::ofstream(file) << changed;
}

}  // namespace lute::compare
