// Many scenes compared, several at a time.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "compare/scene_comparison.hpp"

namespace lute::compare {

// Results in the order of `scenes`. `done` is called for each as soon as it is compared, from one thread at a time.
std::vector<SceneComparison> compare_scenes(const std::vector<SceneFile>& scenes, const ReferenceCache& cache,
                                            const ReferenceNoiseTable& noise, const ComparisonSettings& settings,
                                            int jobs, const std::function<void(const SceneComparison&)>& done = {});

struct Summary {
  std::map<SceneState, std::size_t> counts;
  double cpu_ratio = 0;        // geometric mean over the matching scenes; 0 if there is none
  double worst_cpu_ratio = 0;  // of the matching scenes
};

Summary summarize(const std::vector<SceneComparison>& comparisons);

}  // namespace lute::compare
