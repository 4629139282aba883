// Every pattern of the table has a scene in scenes/feature/pattern; own_scenes_test.cpp compares them with POV-Ray.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <variant>

#include "engine/texture/pattern/table.hpp"
#include "tests/file_text.hpp"

namespace lute {
namespace {

template <class... Patterns>
void expect_scenes(const std::variant<Patterns...>*) {
  for (const std::string_view keyword : {Patterns::kKeyword...}) {
    const std::filesystem::path scene = std::filesystem::path(LUTE_SOURCE_DIR "/scenes/feature/pattern") / (std::string(keyword) + ".pov");
    EXPECT_TRUE(std::filesystem::exists(scene)) << scene;
  }
}

// Patterns whose values need a surface or a file: normal_test.cpp, pattern_test.cpp and pigment_test.cpp have them.
bool has_values_elsewhere(std::string_view keyword) {
  for (const std::string_view k : {"facets", "material_map", "bump_map", "density_file", "slope"})
    if (k == keyword) return true;
  return false;
}

template <class... Patterns>
void expect_values(const std::variant<Patterns...>*) {
  std::string text;
  for (const char* name : {"formulas", "modifiers", "pigments", "tilings"})
    text += test::file_text(std::string(LUTE_SOURCE_DIR "/tests/conformance/pattern/") + name + ".pov");
  for (const std::string_view keyword : {Patterns::kKeyword...}) {
    const bool has_values = text.find("{ " + std::string(keyword)) != std::string::npos;
    EXPECT_NE(has_values, has_values_elsewhere(keyword)) << keyword;
  }
}

TEST(PatternScenes, PrintValuesOfEveryPattern) { expect_values(static_cast<const AnyPattern*>(nullptr)); }

TEST(PatternScenes, ExistForEveryPattern) { expect_scenes(static_cast<const AnyPattern*>(nullptr)); }

}  // namespace
}  // namespace lute
