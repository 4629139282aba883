// The whole way of a comparison, with the reference in both places: every scene must then match itself.
#include "compare/batch.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "compare/report.hpp"
#include "compare/scratch_folder.hpp"

namespace lute::compare {
namespace {

struct Fixture {
  ScratchFolder scenes, cache, output;
  ComparisonSettings settings;

  Fixture() {
    settings.lute_program = "povray";
    settings.output = output.path();
    settings.lute.width = settings.reference.width = 16;
    settings.lute.height = settings.reference.height = 12;
  }
  void write(const std::string& name, const std::string& text) const { std::ofstream(scenes.path() / name) << text; }
  std::vector<SceneComparison> run() const {
    const ReferenceCache reference(cache.path(), "povray");
    return compare_scenes(find_scenes({scenes.path().string()}), reference, {}, settings, 2);
  }
};

constexpr const char* kBall =
    "#version 3.7; camera{location -3*z} light_source{<-9,9,-9> rgb 1} sphere{0,1 pigment{rgb 1}}";

TEST(CompareScenes, ReferenceMatchesItselfAndRejectsWhatItRejects) {
  Fixture fixture;
  fixture.write("ball.pov", kBall);
  fixture.write("wrong.pov", "sphere{");
  const auto results = fixture.run();
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].scene.name, "ball.pov");
  EXPECT_EQ(results[0].state, SceneState::kMatch);
  EXPECT_TRUE(results[0].cpu_ratio());
  EXPECT_EQ(results[1].state, SceneState::kBothReject);
  EXPECT_FALSE(results[1].difference);
}

TEST(CompareScenes, SecondRunTakesTheReferenceFromTheCache) {
  Fixture fixture;
  fixture.write("ball.pov", kBall);
  const double first = fixture.run()[0].reference.wall;
  EXPECT_EQ(fixture.run()[0].reference.wall, first);
}

TEST(CompareScenes, ReportsNameEverySceneAndHoldThePictures) {
  Fixture fixture;
  fixture.write("ball.pov", kBall);
  const auto results = fixture.run();
  std::ostringstream csv, html;
  write_csv(csv, results);
  write_html(html, results, {});
  EXPECT_NE(csv.str().find("ball.pov,match,1.00000,0.00000"), std::string::npos);
  EXPECT_NE(html.str().find("data:image/png;base64,"), std::string::npos);
  EXPECT_EQ(to_json(results, {})["counts"]["match"], 1);
}

TEST(CompareScenes, ProgramThatDoesNotExistIsAnError) {
  Fixture fixture;
  fixture.write("ball.pov", kBall);
  fixture.settings.lute_program = "/no/such/lute";
  EXPECT_THROW(fixture.run(), std::runtime_error);
}

TEST(FindScenes, FilterIsARegularExpressionOnTheRelativeName) {
  Fixture fixture;
  fixture.write("a1.pov", "");
  fixture.write("b1.pov", "");
  fixture.write("b2.inc", "");
  EXPECT_EQ(find_scenes({fixture.scenes.path().string()}).size(), 2u);
  EXPECT_EQ(find_scenes({fixture.scenes.path().string()}, "^b").size(), 1u);
  EXPECT_THROW(find_scenes({"/no/such/folder"}), std::runtime_error);
}

}  // namespace
}  // namespace lute::compare
