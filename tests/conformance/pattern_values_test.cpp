// Values of patterns and colours of pigments against POV-Ray, one by one: the scenes in pattern/ print them with all their digits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "compare/process.hpp"
#include "compare/scratch_folder.hpp"
#include "tests/file_text.hpp"

namespace lute::compare {
namespace {

// What a scene wrote to out.txt: lines of a name, a colon and numbers.
std::vector<std::string> written_by(const std::string& program, const std::string& scene) {
  const ScratchFolder folder;
  ProcessRequest request;
  request.arguments = {program, "+I" + scene, "+W1", "+H1", "-F", "-D", "-V"};
  request.working_directory = folder.path();
  request.standard_error = folder.path() / "said.txt";
  request.time_limit = 60;
  const ProcessResult result = run_process(request);
  EXPECT_TRUE(result.succeeded()) << test::file_text(request.standard_error);
  std::vector<std::string> lines;
  std::istringstream in(test::file_text(folder.path() / "out.txt"));
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> numbers;
  std::istringstream in(line.substr(line.rfind(':') + 1));
  for (std::string word; in >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
  return numbers;
}

bool agree(double a, double b, double tolerance) {
  return (std::isnan(a) && std::isnan(b)) || a == b || std::fabs(a - b) <= tolerance * std::max(1.0, std::fabs(a));
}

struct Case {
  std::string name;
  double tolerance;  // relative above 1
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class PatternValues : public testing::TestWithParam<Case> {};

TEST_P(PatternValues, EqualTheReference) {
  const std::string scene = LUTE_SOURCE_DIR "/tests/conformance/pattern/" + GetParam().name + ".pov";
  const std::vector<std::string> expected = written_by("povray", scene), found = written_by(LUTE_BINARY_DIR "/lute", scene);
  ASSERT_FALSE(expected.empty());
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::vector<double> theirs = numbers_of(expected[i]), ours = numbers_of(found[i]);
    ASSERT_EQ(ours.size(), theirs.size()) << expected[i];
    for (std::size_t k = 0; k < ours.size(); ++k)
      EXPECT_TRUE(agree(theirs[k], ours[k], GetParam().tolerance)) << "POV-Ray: " << expected[i] << "\nlute:    " << found[i];
  }
}

// Patterns are computed in double precision, colours in single precision.
INSTANTIATE_TEST_SUITE_P(All, PatternValues,
                         testing::Values(Case{"formulas", 1e-11}, Case{"modifiers", 1e-11}, Case{"pigments", 7e-8}, Case{"tilings", 4e-7}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace lute::compare
