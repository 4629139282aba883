// The conformance table: the state of every scene, of which none may get worse.
//
// A CSV file with the columns scene, state, within_2_255, rmse, block98_255, sorted by scene; figures are empty when
// there is no pair of pictures. They tell where work pays; only the state is binding.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare/scene_comparison.hpp"

namespace lute::compare {

struct StateRow {
  SceneState state = SceneState::kReferenceTimeout;
  std::optional<double> within, rmse, block98_255;
};

using StateTable = std::map<std::string, StateRow>;

// Throws std::runtime_error for an absent file and for a line that is no row.
StateTable read_states(const std::filesystem::path& csv);
void write_states(const StateTable& table, const std::filesystem::path& csv);

StateRow row_of(const SceneComparison& comparison);

struct StateChange {
  std::string scene;
  std::optional<SceneState> before;  // none: not in the table yet
  SceneState after = SceneState::kDiffers;
};

// A scene that the machine was too slow for is no worse than before: kReferenceTimeout never counts as a change. A scene
// without a row is worse if it does not match.
std::vector<StateChange> worsened(const StateTable& table, const std::vector<SceneComparison>& comparisons);
std::vector<StateChange> improved(const StateTable& table, const std::vector<SceneComparison>& comparisons);

// The scenes of the table that a run over all of them did not find.
std::vector<std::string> missing(const StateTable& table, const std::vector<SceneComparison>& comparisons);

// Takes over new scenes, better states, and better figures of the same state; keeps everything else.
void improve(StateTable& table, const std::vector<SceneComparison>& comparisons);

}  // namespace lute::compare
