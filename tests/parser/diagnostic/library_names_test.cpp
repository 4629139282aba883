#include "parser/diagnostic/library_names.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/parser/diagnostic/golden_scene_list.hpp"

namespace lute::test {
namespace {

const std::vector<std::string> kFolders = {"/nowhere", kDiagnosticFolder + "errors"};

TEST(LibraryNames, KnowTheirFile) {
  const LibraryNames names(kFolders);
  EXPECT_EQ(names.file_of("White"), "colors.inc");
  EXPECT_EQ(names.file_of("Whit"), "");
  EXPECT_EQ(names.file_of("rgb"), "");
  EXPECT_EQ(names.file_of(""), "");
}

TEST(LibraryNames, AFileIsFoundByASlip) {
  EXPECT_EQ(nearest_include(kFolders, "colours.inc"), "colors.inc");
  EXPECT_EQ(nearest_include(kFolders, "textures.inc"), "");
}

}  // namespace
}  // namespace lute::test
