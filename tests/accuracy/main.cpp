// lute-accuracy FILE [CASES]: renders every case of the table in tests/extreme with lute and with POV-Ray, and replaces
// the section "cases" of FILE (docs/accuracy.md) with what came out. With CASES, a regular expression, only those and
// new ones; the other rows stay.
#include <cstdio>
#include <exception>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>

#include "compare/content_hash.hpp"
#include "compare/page_section.hpp"
#include "tests/extreme/extreme_case.hpp"

namespace lute::extreme {
namespace {

std::string share(const Measured& measured) {
  if (!measured.failure.empty()) return measured.failure;
  char text[64];
  std::snprintf(text, sizeof text, measured.error == 0 ? "0" : "%.2f %%", 100 * measured.error);
  return text + (measured.worst.empty() ? "" : " (" + measured.worst + ")");
}

struct Row {
  std::string ours, theirs;
};

// What a row of an earlier table says, by the name of the case.
std::map<std::string, Row> rows_of(const std::string& table) {
  std::map<std::string, Row> rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::smatch parts;
    if (std::regex_match(line, parts, std::regex(R"(\| (\S+) \| (.*?) \| (.*?) \|.*)"))) rows[parts[1]] = {parts[2], parts[3]};
  }
  return rows;
}

bool passes(const std::string& column, double allowed) {
  double percent = 0;
  char sign = 0;
  return column == "0" || (std::sscanf(column.c_str(), "%lf %c", &percent, &sign) == 2 && sign == '%' && percent <= 100 * allowed);
}

std::string table(const std::map<std::string, Row>& rows) {
  std::string text = "| case | lute | POV-Ray | allowed, and why |\n|---|---|---|---|\n";
  int failed = 0, failed_reference = 0;
  for (const ExtremeCase& extreme : cases()) {
    const auto known = rows.find(extreme.name);
    const Row row = known == rows.end() ? Row{"not measured", "not measured"} : known->second;
    failed += passes(row.ours, extreme.allowed) ? 0 : 1;
    failed_reference += passes(row.theirs, extreme.allowed) ? 0 : 1;
    text += "| " + extreme.name + " | " + row.ours + " | " + row.theirs + " | " + extreme.rule + " |\n";
  }
  return "Of " + std::to_string(cases().size()) + " cases lute fails " + std::to_string(failed) + ", POV-Ray " +
         std::to_string(failed_reference) + ".\n\n" + text;
}

// Cases whose name has no match for `again` keep their row of the table before. The page is written after every case, so that
// an end before time costs one.
void rewrite(const char* path, const char* again) {
  const std::regex wanted(again);
  std::map<std::string, Row> rows = rows_of(compare::section_of(compare::read_file(path), "cases"));
  compare::replace_section(path, "cases", table(rows));
  for (const ExtremeCase& extreme : cases()) {
    const auto known = rows.find(extreme.name);
    if (known != rows.end() && known->second.ours != "not measured" && !std::regex_search(extreme.name, wanted)) continue;
    rows[extreme.name] = {share(measure(extreme, LUTE_BINARY_DIR "/lute")), share(measure(extreme, "povray"))};
    std::fprintf(stderr, "%s\n", extreme.name.c_str());
    compare::replace_section(path, "cases", table(rows));
  }
}

}  // namespace
}  // namespace lute::extreme

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::fputs("usage: lute-accuracy docs/accuracy.md [CASES]\n", stderr);
    return 2;
  }
  try {
    lute::extreme::rewrite(argv[1], argc == 3 ? argv[2] : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lute-accuracy: %s: %s\n", argv[1], error.what());
    return 1;
  }
}
