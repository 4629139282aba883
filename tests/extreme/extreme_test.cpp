// Every case of the table, rendered by lute (tests/extreme/extreme_case.hpp).
#include <gtest/gtest.h>

#include <cctype>
#include <ostream>

#include "tests/extreme/extreme_case.hpp"

namespace lute::extreme {

void PrintTo(const ExtremeCase& extreme, std::ostream* out) { *out << extreme.name; }

namespace {

class Extreme : public testing::TestWithParam<ExtremeCase> {};

TEST_P(Extreme, AgreesWithTheOracle) {
  const Measured measured = measure(GetParam(), LUTE_BINARY_DIR "/lute");
  ASSERT_EQ(measured.failure, "");
  EXPECT_LE(measured.error, GetParam().allowed) << measured.worst << "; rule: " << GetParam().rule;
  EXPECT_LE(measured.undecided, kMostUndecided);
}

std::string test_name(const testing::TestParamInfo<ExtremeCase>& info) {
  std::string name;
  for (const char c : info.param.name) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Case, Extreme, testing::ValuesIn(cases()), test_name);

}  // namespace
}  // namespace lute::extreme
