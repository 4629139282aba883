// The definition of 'matches': same file, same size, same switches, no antialiasing, one thread of the reference.
//
// A scene matches when at least 99.5 % of its pixels are within 2/255 in every channel and the RMSE is at most 0.01.
// Some scenes do not match even themselves when the reference uses two threads instead of one (radiosity, photons,
// jitter, crand …). Such a scene, listed with its figures at 160×120 in tests/conformance/reference-noise.csv, matches
// when its RMSE is at most 1.25 times the listed one (at least 0.004) and the 98th percentile of the differences of its
// 8×8-block means is at most 1.5 times the listed one (at least 2/255).
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "compare/difference.hpp"

namespace lute::compare {

constexpr double kPixelTolerance255 = 2;
constexpr double kLeastShareWithin = 0.995;
constexpr double kLargestRmse = 0.01;
constexpr double kNoiseRmseFactor = 1.25, kLeastNoiseRmse = 0.004;
constexpr double kNoiseBlockFactor = 1.5, kLeastNoiseBlock255 = 2;

// The reference against itself with another number of threads.
struct ReferenceNoise {
  double within = 1, rmse = 0, block98_255 = 0;
};

// Scene (its path in the folder of the example scenes) → noise; the file's columns are scene, within_2_255, rmse,
// block98_255. Throws std::runtime_error when the file cannot be read.
class ReferenceNoiseTable {
 public:
  ReferenceNoiseTable() = default;
  explicit ReferenceNoiseTable(const std::filesystem::path& csv);

  // The row that `scene` ends with, folder by folder: the same whether a single file or a folder was asked for.
  std::optional<ReferenceNoise> find(const std::filesystem::path& scene) const;
  std::size_t size() const { return rows_.size(); }

 private:
  std::map<std::string, ReferenceNoise> rows_;
};

bool matches(const Difference& difference, const std::optional<ReferenceNoise>& noise = {});

}  // namespace lute::compare
