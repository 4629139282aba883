// The frames of an animation, and the names of the files that pictures go to. Source: specification chapter 30 §9.5,
// §9.6.
#pragma once

#include <string>
#include <vector>

#include "parser/options/render_options.hpp"
#include "parser/parse.hpp"

namespace lute {

struct Frame {
  int number = 0;    // of the frame; 0 for a still
  double clock = 0;  // of single precision, as the scene sees it
  bool clock_on = false;
  FrameValues values;
};

bool is_animated(const RenderOptions& options);

// One frame for a still; possibly none for a subset beyond the last frame.
std::vector<Frame> frames_of(const RenderOptions& options);

// Where the picture of a frame goes; "-" for standard output.
std::string output_path(const RenderOptions& options, const Frame& frame);

}  // namespace lute
