#include "compare/renderer.hpp"

#include <algorithm>
#include <sstream>
#include <system_error>

#include "compare/content_hash.hpp"
#include "compare/frame_strip.hpp"
#include "compare/scratch_folder.hpp"

namespace lute::compare {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kKeptMessages = 12000;

std::string end_of_file(const fs::path& path) {
  std::error_code missing;
  if (!fs::exists(path, missing)) return {};
  std::string text = read_file(path);
  std::replace(text.begin(), text.end(), '\r', '\n');
  // What a program says first (warnings of the parser) and last (the error) both matter.
  if (text.size() > kKeptMessages) {
    text = text.substr(0, kKeptMessages / 2) + "\n[…]\n" + text.substr(text.size() - kKeptMessages / 2);
  }
  return text;
}

RenderOutcome outcome_of(const ProcessResult& process, const fs::path& picture) {
  if (!process.started) return RenderOutcome::kNotStarted;
  if (process.timed_out) return RenderOutcome::kTimedOut;
  if (process.signal != 0) return RenderOutcome::kCrashed;
  std::error_code missing;
  return process.exit_code == 0 && fs::exists(picture, missing) ? RenderOutcome::kRendered : RenderOutcome::kRejected;
}

// The scene is the input, or the file of options that names its scene itself.
std::vector<std::string> arguments_for(const std::string& program, const fs::path& scene, const fs::path& rendered,
                                       const RenderSettings& settings) {
  const std::string name = scene.filename().string();
  std::vector<std::string> arguments = {program, is_frame_set(scene) ? name : "+I" + name};
  for (const std::string& item : {"+L" + fs::absolute(scene).parent_path().string(), "+O" + rendered.string(), std::string("-D"), std::string("-P")})
    arguments.push_back(item);
  const std::vector<std::string> switches = settings.picture_switches();
  arguments.insert(arguments.end(), switches.begin(), switches.end());
  return arguments;
}

}  // namespace

RenderSettings RenderSettings::for_frames() const {
  RenderSettings frames = *this;
  frames.width = std::max(1, width / 2);
  frames.height = std::max(1, height / 2);
  frames.time_limit = 10 * time_limit;
  return frames;
}

std::vector<std::string> RenderSettings::picture_switches() const {
  std::vector<std::string> all = {"+W" + std::to_string(width), "+H" + std::to_string(height)};
  all.insert(all.end(), switches.begin(), switches.end());
  all.push_back("+F" + file_type);
  return all;
}

const char* name_of(RenderOutcome outcome) {
  switch (outcome) {
    case RenderOutcome::kRendered:
      return "rendered";
    case RenderOutcome::kRejected:
      return "rejected";
    case RenderOutcome::kTimedOut:
      return "timeout";
    case RenderOutcome::kCrashed:
      return "crashed";
    case RenderOutcome::kNotStarted:
      return "not started";
  }
  return "";
}

RenderRun render(const std::string& program, const fs::path& scene, const fs::path& picture,
                 const RenderSettings& of_scene) {
  const RenderSettings settings = is_frame_set(scene) ? of_scene.for_frames() : of_scene;
  const ScratchFolder scratch(fs::absolute(scene).parent_path());
  const ScratchFolder output;
  const fs::path rendered = output.path() / ("picture" + settings.extension());

  ProcessRequest request;
  request.arguments = arguments_for(program, scene, rendered, settings);
  request.working_directory = scratch.path();
  request.standard_error = output.path() / "messages";
  request.time_limit = settings.time_limit;
  request.memory_limit = settings.memory_limit;

  RenderRun run;
  run.process = run_process(request);
  run.messages = end_of_file(request.standard_error);
  if (is_frame_set(scene)) {
    const std::vector<fs::path> frames = frames_beside(rendered);
    if (!frames.empty()) write_picture(strip_of(frames), rendered);
  }
  run.outcome = outcome_of(run.process, rendered);
  if (run.outcome == RenderOutcome::kRendered) {
    if (picture.has_parent_path()) fs::create_directories(picture.parent_path());
    fs::copy_file(rendered, picture, fs::copy_options::overwrite_existing);
    run.picture = picture;
  }
  return run;
}

std::string version_of(const std::string& program) {
  const ScratchFolder output;
  ProcessRequest request;
  request.arguments = {program, "--version"};
  request.standard_output = output.path() / "out";
  request.standard_error = output.path() / "err";
  request.time_limit = 20;
  if (!run_process(request).started) return {};
  std::istringstream lines(read_file(request.standard_output) + "\n" + read_file(request.standard_error));
  for (std::string line; std::getline(lines, line);) {
    const bool names_version = line.rfind("POV-Ray ", 0) == 0 || line.rfind("lute ", 0) == 0;
    if (names_version && line.find_first_of("0123456789") != std::string::npos) return line;
  }
  return {};
}

}  // namespace lute::compare
