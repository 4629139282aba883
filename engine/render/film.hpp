// The picture while it is computed: five-channel colours (rgb, filter, transmit) in the scene's working space, linear light unless
// assumed_gamma says otherwise, never clipped. Columns and rows count from the top left; positions are not checked.
// Source: specification chapter 30 §8.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/image/color.hpp"

namespace lute {

class Film {
 public:
  // Black and opaque everywhere.
  Film(int width, int height)
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  int width() const { return width_; }
  int height() const { return height_; }
  Color& at(int x, int y) { return pixels_[index(x, y)]; }  // (0, 0) is the top left
  const Color& at(int x, int y) const { return pixels_[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_, height_;
  std::vector<Color> pixels_;
};

}  // namespace lute
