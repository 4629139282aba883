#include "parser/options/frames.hpp"

#include <algorithm>
#include <cmath>

namespace lute {
namespace {

int first_frame(const RenderOptions& options) { return std::max(options.initial_frame.value_or(1), 0); }

// The last frame as the scene sees it: of a cyclic animation one more, equal to the first.
int final_frame(const RenderOptions& options) {
  return std::max(options.final_frame.value_or(1), first_frame(options)) + (options.cyclic ? 1 : 0);
}

// A frame number, or below 1 a fraction of the animation.
int subset_frame(double given, int first, int last) {
  if (given > 0 && given < 1) return static_cast<int>((last - first + 1) * given);
  return static_cast<int>(std::min(given, 1e9));
}

double single(double value) { return static_cast<double>(static_cast<float>(value)); }

struct PathParts {
  std::string folder;  // with its slash
  std::string name;
};

PathParts split(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return {"", path};
  return {path.substr(0, slash + 1), path.substr(slash + 1)};
}

std::string without_extension(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}

// The number of the frame, as long as that of the last one. A number beyond it keeps all its digits; POV-Ray lets the
// further ones take the place of the name's last letters, and of the folder's slash.
std::string frame_suffix(const RenderOptions& options, const Frame& frame) {
  if (!is_animated(options)) return "";
  std::string digits = std::to_string(frame.number);
  const std::size_t width = std::to_string(final_frame(options)).size();
  if (digits.size() < width) digits.insert(0, width - digits.size(), '0');
  return digits;
}

}  // namespace

bool is_animated(const RenderOptions& options) {
  const int first = options.initial_frame.value_or(0), last = options.final_frame.value_or(0);
  return !(first == 0 && last == 0) && !(first == 1 && last == 1);
}

std::vector<Frame> frames_of(const RenderOptions& options) {
  if (!is_animated(options)) return {{0, single(options.clock), options.clock_given, {}}};
  const int first = first_frame(options), last = final_frame(options);
  // One frame alone divides by zero, as in the reference: the scene sees an infinite clock_delta.
  const double delta = (options.final_clock - options.initial_clock) / (last - first);
  int begin = options.subset_start ? subset_frame(*options.subset_start, first, last) : first;
  begin = std::max(begin, first);
  int end = options.subset_end ? subset_frame(*options.subset_end, first, last) : last - (options.cyclic ? 1 : 0);
  end = std::max(end, begin);  // not held to the last frame, as in the reference: the clock runs on
  std::vector<Frame> frames;
  for (int n = begin; n <= end; n += options.frame_step) {
    const double clock = delta * (n - first) + options.initial_clock;
    frames.push_back({n, single(clock), true, {n, first, last, options.initial_clock, options.final_clock, delta}});
  }
  return frames;
}

std::string output_path(const RenderOptions& options, const Frame& frame) {
  const std::string& given = options.output_file;
  if (given == "-" || given == "stdout") return "-";
  const std::string extension(traits_of(options.output.format).extension);
  PathParts parts = split(given);
  if (parts.name.empty() || parts.name == extension) {
    // The scene's name; beside the scene when not even a folder is given.
    const PathParts input = split(options.input_file == "-" ? "stdin" : options.input_file);
    if (parts.folder.empty()) parts.folder = input.folder;
    parts.name = without_extension(input.name);
  } else if (parts.name.ends_with(extension)) {
    parts.name.resize(parts.name.size() - extension.size());
  } else if (parts.name.ends_with('.')) {
    parts.name.pop_back();
  }
  return parts.folder + parts.name + frame_suffix(options, frame) + extension;
}

}  // namespace lute
