#include "compare/scene_comparison.hpp"

#include <array>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "compare/frame_strip.hpp"

namespace lute::compare {
namespace fs = std::filesystem;

namespace {

constexpr std::array<std::pair<SceneState, const char*>, 9> kStateNames = {{
    {SceneState::kMatch, "match"},
    {SceneState::kBothReject, "both-reject"},
    {SceneState::kDiffers, "differs"},
    {SceneState::kUnsupported, "unsupported"},
    {SceneState::kLuteError, "lute-error"},
    {SceneState::kTimeout, "timeout"},
    {SceneState::kLuteCrash, "lute-crash"},
    {SceneState::kReferenceRejects, "reference-rejects"},
    {SceneState::kReferenceTimeout, "reference-timeout"},
}};

constexpr std::string_view kNotRenderedYet = "not rendered yet";

// The first line of `messages` that holds one of the words; empty if none does.
std::string first_line_with(const std::string& messages, std::initializer_list<std::string_view> words) {
  for (const std::string_view word : words) {
    std::istringstream lines(messages);
    for (std::string line; std::getline(lines, line);) {
      if (line.find(word) != std::string::npos) return line;
    }
  }
  return {};
}

SceneState state_of(const SceneComparison& comparison) {
  const RenderOutcome reference = comparison.reference.outcome;
  const RenderOutcome lute = comparison.lute.outcome;
  if (reference == RenderOutcome::kTimedOut) return SceneState::kReferenceTimeout;
  if (lute == RenderOutcome::kTimedOut) return SceneState::kTimeout;
  if (lute == RenderOutcome::kCrashed) return SceneState::kLuteCrash;
  if (reference != RenderOutcome::kRendered) {
    return lute == RenderOutcome::kRejected ? SceneState::kBothReject : SceneState::kReferenceRejects;
  }
  const bool unsupported = comparison.lute.messages.find(kNotRenderedYet) != std::string::npos;
  if (lute != RenderOutcome::kRendered) return unsupported ? SceneState::kUnsupported : SceneState::kLuteError;
  if (matches(*comparison.difference, comparison.noise)) return SceneState::kMatch;
  return unsupported ? SceneState::kUnsupported : SceneState::kDiffers;
}

std::string reason_of(const SceneComparison& comparison) {
  switch (comparison.state) {
    case SceneState::kUnsupported:
      return first_line_with(comparison.lute.messages, {kNotRenderedYet});
    case SceneState::kLuteError:
      return first_line_with(comparison.lute.messages, {"error", "rror"});
    case SceneState::kLuteCrash:
      return "ended by signal " + std::to_string(comparison.lute.process.signal);
    case SceneState::kReferenceRejects:
      return first_line_with(comparison.reference.messages, {"Error:", "error", "rror"});
    case SceneState::kDiffers:
      return comparison.frames > 1 ? "frame " + std::to_string(comparison.worst_frame + 1) + " of " + std::to_string(comparison.frames) : "";
    default:
      return {};
  }
}

// The row of a frame is that of the set with its number, from 1, behind it; without one that of the set's scene counts.
FrameNoise frame_noise(const fs::path& set, const ReferenceNoiseTable& noise) {
  const fs::path path = fs::absolute(set).lexically_normal();
  const std::optional<ReferenceNoise> of_scene = noise.find(scene_of_set(path).value_or(path));
  return [path, of_scene, &noise](int frame) {
    const std::optional<ReferenceNoise> own = noise.find(path / std::to_string(frame + 1));
    return own ? own : of_scene;
  };
}

// The worst frame stands for all, also in the report's pictures.
void compare_frames(SceneComparison& comparison, const Picture& rendered, const Picture& expected, int height,
                    const ReferenceNoiseTable& noise, const std::string& base) {
  const WorstFrame worst = worst_frame(rendered, expected, height, frame_noise(comparison.scene.path, noise));
  comparison.noise = worst.noise;
  comparison.difference = worst.difference;
  comparison.frames = worst.count;
  comparison.worst_frame = worst.index;
  comparison.lute.picture = base + ".worst.lute.png";
  comparison.reference.picture = base + ".worst.reference.png";
  comparison.heat_map = base + ".heat.png";
  write_picture(worst.a, comparison.lute.picture);
  write_picture(worst.b, comparison.reference.picture);
  write_picture(heat_map(worst.a, worst.b), comparison.heat_map);
}

}  // namespace

const char* name_of(SceneState state) {
  for (const auto& [value, name] : kStateNames) {
    if (value == state) return name;
  }
  return "";
}

SceneState state_named(const std::string& wanted) {
  for (const auto& [value, name] : kStateNames) {
    if (wanted == name) return value;
  }
  throw std::runtime_error("unknown state of a scene: " + wanted);
}

bool is_good(SceneState state) { return state == SceneState::kMatch || state == SceneState::kBothReject; }

std::optional<double> SceneComparison::cpu_ratio() const {
  const bool both = reference.outcome == RenderOutcome::kRendered && lute.outcome == RenderOutcome::kRendered;
  if (!both || reference.cpu <= 0 || lute.process.cpu <= 0) return {};
  return lute.process.cpu / reference.cpu;
}

SceneComparison compare_scene(const SceneFile& scene, const ReferenceCache& cache, const ReferenceNoiseTable& noise,
                              const ComparisonSettings& settings) {
  SceneComparison comparison;
  comparison.scene = scene;
  comparison.noise = noise.find(fs::absolute(scene.path).lexically_normal());
  comparison.reference = cache.get(scene.path, settings.reference, settings.measure_again);
  if (comparison.reference.outcome == RenderOutcome::kTimedOut) {
    comparison.state = SceneState::kReferenceTimeout;
    return comparison;
  }
  const fs::path base = settings.output / scene.name;
  comparison.lute = render(settings.lute_program, scene.path, base.string() + ".lute.png", settings.lute);
  if (comparison.lute.outcome == RenderOutcome::kNotStarted) {
    throw std::runtime_error("cannot run '" + settings.lute_program + "'");
  }
  if (!comparison.reference.picture.empty() && !comparison.lute.picture.empty()) {
    const Picture expected = read_picture(comparison.reference.picture);
    const Picture rendered = read_picture(comparison.lute.picture);
    if (is_frame_set(scene.path)) {
      compare_frames(comparison, rendered, expected, settings.lute.for_frames().height, noise, base.string());
    } else {
      comparison.difference = difference(rendered, expected, kPixelTolerance255);
      comparison.heat_map = base.string() + ".heat.png";
      write_picture(heat_map(rendered, expected), comparison.heat_map);
    }
  }
  comparison.state = state_of(comparison);
  comparison.reason = reason_of(comparison);
  return comparison;
}

}  // namespace lute::compare
