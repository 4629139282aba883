// lute-accuracy FILE: renders every case of the table in tests/extreme with lute and with POV-Ray, and replaces the
// table between the two marks in FILE (docs/accuracy.md) with what came out.
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "tests/extreme/extreme_case.hpp"

namespace lute::extreme {
namespace {

constexpr const char* kBegin = "<!-- cases: written by lute-accuracy -->\n";
constexpr const char* kEnd = "<!-- end of cases -->\n";

std::string share(const Measured& measured) {
  if (!measured.failure.empty()) return measured.failure;
  char text[64];
  std::snprintf(text, sizeof text, measured.error == 0 ? "0" : "%.2f %%", 100 * measured.error);
  return text + (measured.worst.empty() ? "" : " (" + measured.worst + ")");
}

std::string table() {
  std::string text = "| case | lute | POV-Ray | allowed, and why |\n|---|---|---|---|\n";
  int failed = 0, failed_reference = 0;
  for (const ExtremeCase& extreme : cases()) {
    const Measured ours = measure(extreme, LUTE_BINARY_DIR "/lute"), theirs = measure(extreme, "povray");
    failed += ours.failure.empty() && ours.error <= extreme.allowed ? 0 : 1;
    failed_reference += theirs.failure.empty() && theirs.error <= extreme.allowed ? 0 : 1;
    text += "| " + extreme.name + " | " + share(ours) + " | " + share(theirs) + " | " + extreme.rule + " |\n";
    std::fprintf(stderr, "%s\n", extreme.name.c_str());
  }
  return "Of " + std::to_string(cases().size()) + " cases lute fails " + std::to_string(failed) + ", POV-Ray " +
         std::to_string(failed_reference) + ".\n\n" + text;
}

void rewrite(const char* path) {
  std::ifstream in(path);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  const std::size_t begin = text.find(kBegin), end = text.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos) throw std::runtime_error("no marks in the file");
  const std::string whole = text.substr(0, begin) + kBegin + "\n" + table() + "\n" + text.substr(end);
  std::ofstream(path) << whole;
}

}  // namespace
}  // namespace lute::extreme

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: lute-accuracy docs/accuracy.md\n", stderr);
    return 2;
  }
  try {
    lute::extreme::rewrite(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lute-accuracy: %s: %s\n", argv[1], error.what());
    return 1;
  }
}
