// Pictures and times of the reference, kept by content: a scene is rendered by POV-Ray once for each text, size and set
// of switches. The cache lives in $LUTE_CACHE, or ~/.cache/lute, in the folder `reference`.
#pragma once

#include <filesystem>
#include <string>

#include "compare/renderer.hpp"

namespace lute::compare {

struct ReferenceResult {
  RenderOutcome outcome = RenderOutcome::kNotStarted;
  std::filesystem::path picture;  // exists only if rendered
  double wall = 0, cpu = 0;       // seconds
  std::string messages;
};

class ReferenceCache {
 public:
  ReferenceCache(std::filesystem::path folder, std::string program);

  // From the cache, or rendered now. A run that hit its time limit is repeated only when `settings` allow more time.
  // `measure_again` renders even what is cached, for times that no other load disturbed.
  ReferenceResult get(const std::filesystem::path& scene, const RenderSettings& settings,
                      bool measure_again = false) const;

  const std::string& version() const { return version_; }

  static std::filesystem::path default_folder();

 private:
  std::filesystem::path folder_;
  std::string program_;
  std::string version_;
};

}  // namespace lute::compare
