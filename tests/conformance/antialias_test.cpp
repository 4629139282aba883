// Antialiasing by methods 1 and 2 takes the samples that POV-Ray takes, and gives its picture.
#include <gtest/gtest.h>

#include "compare/sample_counts.hpp"

namespace lute::compare {
namespace {

struct Case {
  const char* name;
  const char* scene;
  const char* switches;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Antialiased : public testing::TestWithParam<Case> {};

TEST_P(Antialiased, TakesTheSamplesOfTheReference) {
  const std::string scene = std::string(LUTE_SOURCE_DIR) + "/scenes/" + GetParam().scene;
  RenderSettings settings;
  settings.time_limit = 120;
  const SampleCount count =
      count_samples({scene, GetParam().scene}, GetParam().switches, settings, LUTE_BINARY_DIR "/lute", "povray");
  EXPECT_NEAR(count.own, count.reference, kAllowedSampleDifference * count.reference);
  EXPECT_TRUE(count.matches) << "within 2/255: " << count.within;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const auto& [name, scene] :
       {std::pair{"Lute", "showcase/lute.pov"}, std::pair{"Refraction", "lecture/refraction.pov"},
        std::pair{"Brick", "lecture/brick.pov"}}) {
    all.push_back({name, scene, "+A0.3"});
    all.push_back({name, scene, "+AM2 +A0.1 +R3"});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Antialiased, testing::ValuesIn(cases()), [](const auto& test) {
  return std::string(test.param.name) + (test.param.switches == std::string("+A0.3") ? "MethodOne" : "MethodTwo");
});

}  // namespace
}  // namespace lute::compare
