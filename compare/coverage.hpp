// The page docs/coverage.md: what of the language renders as POV-Ray renders it. Nothing on it is written by hand: a
// feature works when the small scene that shows it matches, and the example scenes say how far that carries.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "compare/scene_comparison.hpp"
#include "compare/state_table.hpp"

namespace lute::compare {

// The first comment of a scene file, up to its first full stop: what the scene shows. Empty if it begins otherwise.
std::string subject_of_scene(const std::filesystem::path& scene);

// `features` are named relative to the folder of scenes (feature/shape/torus.pov): one table a folder, one row a scene.
// `examples` are counted by their top folder.
void write_coverage(std::ostream& markdown, const std::vector<SceneComparison>& features, const StateTable& examples);

}  // namespace lute::compare
