#include "compare/frame_strip.hpp"

#include <algorithm>
#include <limits>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "compare/content_hash.hpp"

namespace lute::compare {
namespace fs = std::filesystem;

namespace {

// Rows `index` · height and following; a missing frame has no number at all, which counts as the largest difference.
Picture frame_of(const Picture& strip, int index, int height) {
  Picture frame(strip.width, height);
  if ((index + 1) * height > strip.height) {
    std::ranges::fill(frame.values, std::numeric_limits<float>::quiet_NaN());
    return frame;
  }
  const float* first = strip.at(0, index * height);
  std::copy(first, first + frame.values.size(), frame.values.begin());
  return frame;
}

}  // namespace

bool is_frame_set(const fs::path& scene) { return scene.extension() == ".ini"; }

std::optional<fs::path> scene_of_set(const fs::path& ini) {
  static const std::regex names_scene(R"(^\s*Input_File_Name\s*=\s*"?([^";\s]+))", std::regex::icase);
  std::istringstream lines(read_file(ini));
  std::smatch found;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_search(line, found, names_scene)) return ini.parent_path() / found[1].str();
  return {};
}

std::vector<fs::path> frames_beside(const fs::path& picture) {
  const std::string stem = picture.stem().string();
  std::vector<fs::path> frames;
  for (const fs::directory_entry& entry : fs::directory_iterator(picture.parent_path())) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != picture.extension() || !name.starts_with(stem)) continue;
    if (std::all_of(name.begin() + static_cast<std::ptrdiff_t>(stem.size()), name.end(), [](char c) { return c >= '0' && c <= '9'; }))
      frames.push_back(entry.path());
  }
  std::ranges::sort(frames);  // the numbers have as many digits each
  return frames;
}

Picture strip_of(const std::vector<fs::path>& frames) {
  Picture strip;
  for (const fs::path& path : frames) {
    const Picture frame = read_picture(path);
    if (strip.height > 0 && frame.width != strip.width) throw std::runtime_error("frames of different sizes: " + path.string());
    strip.width = frame.width;
    strip.height += frame.height;
    strip.values.insert(strip.values.end(), frame.values.begin(), frame.values.end());
  }
  return strip;
}

WorstFrame worst_frame(const Picture& a, const Picture& b, int frame_height, const FrameNoise& noise) {
  if (a.width != b.width) throw std::runtime_error("frames of different widths");
  WorstFrame worst;
  worst.count = std::max(a.height, b.height) / frame_height;
  for (int i = 0; i < worst.count; ++i) {
    Picture frame_a = frame_of(a, i, frame_height), frame_b = frame_of(b, i, frame_height);
    const Difference d = difference(frame_a, frame_b, kPixelTolerance255);
    const std::optional<ReferenceNoise> own = noise(i);
    const bool good = matches(d, own), worst_is_good = matches(worst.difference, worst.noise);
    if (i > 0 && (good != worst_is_good ? good : d.rmse <= worst.difference.rmse)) continue;
    worst.index = i;
    worst.difference = d;
    worst.noise = own;
    worst.a = std::move(frame_a);
    worst.b = std::move(frame_b);
  }
  return worst;
}

}  // namespace lute::compare
