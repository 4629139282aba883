#include "parser/diagnostic/library_names.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/parser/diagnostic/golden_scene_list.hpp"

namespace lute::test {
namespace {

const std::vector<std::string> kFolders = {"/nowhere", kDiagnosticFolder + "errors"};

TEST(LibraryNames, KnowTheirFile) {
  const LibraryNames names(kFolders);
  ASSERT_EQ(names.files_of("White").size(), 1u);
  EXPECT_EQ(names.files_of("White").front(), "colors.inc");
  EXPECT_TRUE(names.files_of("Whit").empty());
  EXPECT_TRUE(names.files_of("rgb").empty());
  EXPECT_TRUE(names.files_of("").empty());
}

TEST(LibraryNames, AFileIsFoundByASlip) {
  EXPECT_EQ(nearest_include(kFolders, "colours.inc"), "colors.inc");
  EXPECT_EQ(nearest_include(kFolders, "textures.inc"), "");
}

}  // namespace
}  // namespace lute::test
