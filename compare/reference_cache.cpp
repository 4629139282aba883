#include "compare/reference_cache.hpp"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "compare/content_hash.hpp"

namespace lute::compare {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr RenderOutcome kOutcomes[] = {RenderOutcome::kRendered, RenderOutcome::kRejected, RenderOutcome::kTimedOut,
                                       RenderOutcome::kCrashed, RenderOutcome::kNotStarted};

RenderOutcome outcome_named(const std::string& name) {
  for (const RenderOutcome outcome : kOutcomes) {
    if (name == name_of(outcome)) return outcome;
  }
  return RenderOutcome::kNotStarted;
}

// A cached entry that still answers the question; none if the last run needed more time than allowed then.
std::optional<ReferenceResult> read_entry(const fs::path& record, const fs::path& picture, double time_limit) {
  std::ifstream stream(record);
  if (!stream) return {};
  const json entry = json::parse(stream, nullptr, false);
  if (entry.is_discarded()) return {};
  ReferenceResult result;
  result.outcome = outcome_named(entry.value("outcome", ""));
  result.wall = entry.value("wall", 0.0);
  result.cpu = entry.value("cpu", 0.0);
  result.messages = entry.value("messages", "");
  if (result.outcome == RenderOutcome::kNotStarted) return {};
  if (result.outcome == RenderOutcome::kTimedOut && (time_limit == 0 || entry.value("time_limit", 0.0) < time_limit))
    return {};
  if (result.outcome == RenderOutcome::kRendered) {
    if (!fs::exists(picture)) return {};
    result.picture = picture;
  }
  return result;
}

// Written beside its place and renamed, so that another process never reads half an entry.
void write_entry(const fs::path& record, const fs::path& scene, const RenderRun& run, const RenderSettings& settings) {
  const json entry = {{"scene", fs::absolute(scene).string()},
                      {"outcome", name_of(run.outcome)},
                      {"wall", run.process.wall},
                      {"cpu", run.process.cpu},
                      {"peak_memory", run.process.peak_memory},
                      {"time_limit", settings.time_limit},
                      {"messages", run.messages}};
  const fs::path draft = record.string() + "." + std::to_string(getpid());
  std::ofstream(draft) << entry.dump(2, ' ', false, json::error_handler_t::replace) << '\n';
  fs::rename(draft, record);
}

}  // namespace

ReferenceCache::ReferenceCache(fs::path folder, std::string program)
    : folder_(std::move(folder)), program_(std::move(program)), version_(version_of(program_)) {
  if (version_.empty()) throw std::runtime_error("cannot run the reference '" + program_ + "'");
}

fs::path ReferenceCache::default_folder() {
  if (const char* folder = std::getenv("LUTE_CACHE"); folder != nullptr && *folder != '\0')
    return fs::path(folder) / "reference";
  const char* home = std::getenv("HOME");
  return (home != nullptr ? fs::path(home) : fs::temp_directory_path()) / ".cache" / "lute" / "reference";
}

ReferenceResult ReferenceCache::get(const fs::path& scene, const RenderSettings& settings, bool measure_again) const {
  const std::string key = scene_hash(scene, settings.picture_switches(), version_);
  const fs::path record = folder_ / key.substr(0, 2) / (key + ".json");
  const fs::path picture = folder_ / key.substr(0, 2) / (key + settings.extension());
  if (!measure_again) {
    if (const auto cached = read_entry(record, picture, settings.time_limit)) return *cached;
  }
  fs::create_directories(record.parent_path());
  const RenderRun run = render(program_, scene, picture, settings);
  if (run.outcome == RenderOutcome::kNotStarted)
    throw std::runtime_error("cannot run the reference '" + program_ + "'");
  write_entry(record, scene, run, settings);
  return {run.outcome, run.picture, run.process.wall, run.process.cpu, run.messages};
}

}  // namespace lute::compare
