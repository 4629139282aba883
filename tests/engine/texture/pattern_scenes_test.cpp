// Every pattern of the table has a scene in scenes/feature/pattern; own_scenes_test.cpp compares them with POV-Ray.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <variant>

#include "engine/texture/pattern/table.hpp"

namespace lute {
namespace {

template <class... Patterns>
void expect_scenes(const std::variant<Patterns...>*) {
  for (const std::string_view keyword : {Patterns::kKeyword...}) {
    const std::filesystem::path scene = std::filesystem::path(LUTE_SOURCE_DIR "/scenes/feature/pattern") / (std::string(keyword) + ".pov");
    EXPECT_TRUE(std::filesystem::exists(scene)) << scene;
  }
}

TEST(PatternScenes, ExistForEveryPattern) { expect_scenes(static_cast<const AnyPattern*>(nullptr)); }

}  // namespace
}  // namespace lute
