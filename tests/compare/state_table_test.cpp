#include "compare/state_table.hpp"

#include <gtest/gtest.h>

#include "compare/scratch_folder.hpp"

namespace lute::compare {
namespace {

SceneComparison result(const std::string& scene, SceneState state, double rmse = 0.02) {
  SceneComparison comparison;
  comparison.scene.name = scene;
  comparison.state = state;
  comparison.difference.emplace();
  comparison.difference->rmse = rmse;
  return comparison;
}

TEST(StateTable, SurvivesWritingAndReading) {
  const ScratchFolder folder;
  StateTable table;
  table["a/b.pov"] = {SceneState::kDiffers, 0.5, 0.25, 3.0};
  table["c.pov"] = {SceneState::kBothReject, {}, {}, {}};
  write_states(table, folder.path() / "state.csv");
  const StateTable again = read_states(folder.path() / "state.csv");
  ASSERT_EQ(again.size(), 2u);
  EXPECT_EQ(again.at("a/b.pov").state, SceneState::kDiffers);
  EXPECT_EQ(again.at("a/b.pov").rmse, 0.25);
  EXPECT_FALSE(again.at("c.pov").rmse);
}

TEST(StateTable, OnlyImproves) {
  StateTable table;
  table["better.pov"] = {SceneState::kDiffers, {}, 0.02, {}};
  table["worse.pov"] = {SceneState::kMatch, {}, 0.001, {}};
  const std::vector<SceneComparison> run = {result("better.pov", SceneState::kMatch),
                                            result("worse.pov", SceneState::kDiffers),
                                            result("new.pov", SceneState::kLuteError)};
  ASSERT_EQ(worsened(table, run).size(), 2u);
  EXPECT_EQ(worsened(table, run)[0].scene, "worse.pov");
  EXPECT_EQ(worsened(table, run)[1].scene, "new.pov");
  ASSERT_EQ(improved(table, run).size(), 1u);
  EXPECT_EQ(improved(table, run)[0].scene, "better.pov");
  improve(table, run);
  EXPECT_EQ(table["better.pov"].state, SceneState::kMatch);
  EXPECT_EQ(table["worse.pov"].state, SceneState::kMatch);
  EXPECT_EQ(table["new.pov"].state, SceneState::kLuteError);
}

TEST(StateTable, AbsentTableIsAnError) {
  const ScratchFolder folder;
  EXPECT_THROW(read_states(folder.path() / "none.csv"), std::runtime_error);
}

TEST(StateTable, TellsScenesThatARunDidNotFind) {
  StateTable table;
  table["found.pov"] = table["lost.pov"] = {SceneState::kMatch, {}, 0.001, {}};
  EXPECT_EQ(missing(table, {result("found.pov", SceneState::kMatch)}), std::vector<std::string>{"lost.pov"});
}

TEST(StateTable, SlowReferenceIsNoWorsening) {
  StateTable table;
  table["slow.pov"] = {SceneState::kMatch, {}, 0.001, {}};
  EXPECT_TRUE(worsened(table, {result("slow.pov", SceneState::kReferenceTimeout)}).empty());
}

TEST(StateTable, EveryStateHasANameThatReadsBack) {
  for (int i = 0; i <= static_cast<int>(SceneState::kReferenceTimeout); ++i) {
    const auto state = static_cast<SceneState>(i);
    EXPECT_EQ(state_named(name_of(state)), state);
  }
  EXPECT_THROW(state_named("fine"), std::runtime_error);
}

}  // namespace
}  // namespace lute::compare
