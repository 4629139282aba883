// Golden files: what a test recorded earlier. With LUTE_UPDATE_GOLDEN set in the environment a test writes its file anew and is
// skipped, so that nothing is compared with itself; read the difference before committing it.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/file_text.hpp"

namespace lute::test {

inline bool golden_is_renewed() { return std::getenv("LUTE_UPDATE_GOLDEN") != nullptr; }

// The last statement of a test: marks it as skipped.
inline void renew_golden(const std::filesystem::path& golden, const std::string& text) {
  std::ofstream file(golden, std::ios::binary);
  file << text;
  file.close();
  ASSERT_TRUE(file.good()) << "cannot write " << golden;
  GTEST_SKIP() << "renewed, not tested: " << golden;
}

// The last statement of a test whose result is one whole file.
inline void expect_golden(const std::filesystem::path& golden, const std::string& text) {
  if (golden_is_renewed()) return renew_golden(golden, text);
  ASSERT_TRUE(std::filesystem::exists(golden)) << golden << " is missing: LUTE_UPDATE_GOLDEN=1 writes it";
  EXPECT_EQ(text, file_text(golden)) << golden << "\nAfter an intended change LUTE_UPDATE_GOLDEN=1 writes it anew.";
}

}  // namespace lute::test
