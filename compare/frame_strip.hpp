// Sets of frames: an INI file that names a scene and, most often, a range of frames to render it with (specification chapter 30 §9).
//
// The frames that a program writes are kept as one picture, a strip: one frame under the other, in the order of their numbers.
// So a set of frames has one picture as a scene has, in the cache and in reports; frame i is rows i·h … (i+1)·h − 1.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "compare/difference.hpp"
#include "compare/match.hpp"

namespace lute::compare {

// By its extension.
bool is_frame_set(const std::filesystem::path& scene);

// The scene that an INI file names; none if it names no scene. Throws std::runtime_error when the file cannot be read.
std::optional<std::filesystem::path> scene_of_set(const std::filesystem::path& ini);

// The pictures that a program wrote beside `picture`, with a frame number in front of the extension; in order of their numbers.
std::vector<std::filesystem::path> frames_beside(const std::filesystem::path& picture);

// Throws std::runtime_error when the frames differ in size.
Picture strip_of(const std::vector<std::filesystem::path>& frames);

// The pair of frames that is farthest apart: one that does not match before all that do, then the larger RMSE.
struct WorstFrame {
  int index = 0, count = 0;  // from 0; of the longer strip
  Difference difference;
  std::optional<ReferenceNoise> noise;
  Picture a, b;
};

// How far the reference is from itself in a frame, counted from 0; none: not at all.
using FrameNoise = std::function<std::optional<ReferenceNoise>(int frame)>;

// A frame that only one strip has differs in every pixel. Throws std::runtime_error when the widths differ.
WorstFrame worst_frame(const Picture& a, const Picture& b, int frame_height, const FrameNoise& noise);

}  // namespace lute::compare
