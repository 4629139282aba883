#include "compare/match.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace lute::compare {

ReferenceNoiseTable::ReferenceNoiseTable(const std::filesystem::path& csv) {
  std::ifstream stream(csv);
  if (!stream) throw std::runtime_error("cannot read " + csv.string());
  std::string line;
  std::getline(stream, line);  // the names of the columns
  while (std::getline(stream, line)) {
    if (line.empty()) continue;
    std::istringstream fields(line);
    std::string scene;
    ReferenceNoise noise;
    char comma = 0;
    std::getline(fields, scene, ',');
    if (!(fields >> noise.within >> comma >> noise.rmse >> comma >> noise.block98_255)) {
      throw std::runtime_error("not a line of noise figures in " + csv.string() + ": " + line);
    }
    rows_[scene] = noise;
  }
}

std::optional<ReferenceNoise> ReferenceNoiseTable::find(const std::filesystem::path& scene) const {
  for (auto first = scene.begin(); first != scene.end(); ++first) {
    std::filesystem::path tail;
    for (auto part = first; part != scene.end(); ++part) tail /= *part;
    if (const auto row = rows_.find(tail.generic_string()); row != rows_.end()) return row->second;
  }
  return {};
}

bool matches(const Difference& difference, const std::optional<ReferenceNoise>& noise) {
  if (difference.within >= kLeastShareWithin && difference.rmse <= kLargestRmse) return true;
  if (!noise) return false;
  return difference.rmse <= std::max(kNoiseRmseFactor * noise->rmse, kLeastNoiseRmse) &&
         difference.block98_255 <= std::max(kNoiseBlockFactor * noise->block98_255, kLeastNoiseBlock255);
}

}  // namespace lute::compare
