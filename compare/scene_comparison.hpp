// One scene rendered by both programs and compared.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "compare/difference.hpp"
#include "compare/match.hpp"
#include "compare/reference_cache.hpp"
#include "compare/renderer.hpp"
#include "compare/scene_files.hpp"

namespace lute::compare {

// From best to worst; a conformance state may only move towards the front.
enum class SceneState {
  kMatch,             // the pictures match, see match.hpp
  kBothReject,        // the reference rejects the scene, and so does lute
  kDiffers,           // both render, the pictures do not match
  kUnsupported,       // differs or fails, and lute said that it does not render something yet
  kLuteError,         // lute rejects what the reference renders
  kTimeout,           // lute did not end in time
  kLuteCrash,         // a signal ended lute
  kReferenceRejects,  // lute renders what the reference rejects
  kReferenceTimeout,  // no reference picture in time: nothing to compare with
};

const char* name_of(SceneState state);
// Throws std::runtime_error for an unknown name.
SceneState state_named(const std::string& name);
bool is_good(SceneState state);  // kMatch or kBothReject

struct SceneComparison {
  SceneFile scene;
  SceneState state = SceneState::kReferenceTimeout;
  std::optional<Difference> difference;  // if both rendered; of the worst frame of a set of frames
  int frames = 1, worst_frame = 0;       // of a set of frames; counted from 0
  std::optional<ReferenceNoise> noise;   // if the reference differs from itself
  ReferenceResult reference;
  RenderRun lute;
  std::filesystem::path heat_map;  // if both rendered
  std::string reason;              // the first line that tells why, for states other than a match

  // Processor time of lute over that of the reference; none unless both rendered.
  std::optional<double> cpu_ratio() const;
};

struct ComparisonSettings {
  RenderSettings reference;
  RenderSettings lute;
  std::string lute_program = "lute";
  std::filesystem::path output;  // pictures and heat maps are put here, by the scenes' names
  bool measure_again = false;    // render the reference even when it is cached
};

SceneComparison compare_scene(const SceneFile& scene, const ReferenceCache& cache, const ReferenceNoiseTable& noise,
                              const ComparisonSettings& settings);

}  // namespace lute::compare
