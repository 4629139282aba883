#include "compare/batch.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

namespace lute::compare {

std::vector<SceneComparison> compare_scenes(const std::vector<SceneFile>& scenes, const ReferenceCache& cache,
                                            const ReferenceNoiseTable& noise, const ComparisonSettings& settings,
                                            int jobs, const std::function<void(const SceneComparison&)>& done) {
  std::vector<SceneComparison> results(scenes.size());
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < scenes.size(); i = next++) {
        results[i] = compare_scene(scenes[i], cache, noise, settings);
        const std::lock_guard lock(mutex);
        if (done) done(results[i]);
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      next = scenes.size();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < std::max(jobs, 1); ++i) threads.emplace_back(work);
  }
  if (failure) std::rethrow_exception(failure);
  return results;
}

Summary summarize(const std::vector<SceneComparison>& comparisons) {
  Summary summary;
  double logarithms = 0;
  std::size_t counted = 0;
  for (const SceneComparison& comparison : comparisons) {
    ++summary.counts[comparison.state];
    const auto ratio = comparison.cpu_ratio();
    if (comparison.state != SceneState::kMatch || !ratio) continue;
    logarithms += std::log(*ratio);
    summary.worst_cpu_ratio = std::max(summary.worst_cpu_ratio, *ratio);
    ++counted;
  }
  if (counted > 0) summary.cpu_ratio = std::exp(logarithms / static_cast<double>(counted));
  return summary;
}

}  // namespace lute::compare
